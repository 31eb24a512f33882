// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/stiction/stiction_method.h"

#include <fmt/format.h>

#include <type_traits>
#include <utility>
#include <vector>

#include "solver/demand.h"
#include "solver/friction/catalog.h"

namespace stiction {

namespace {

// Words of a setting and what they mean to the solver.
template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;

const Words<bool> kSwitch = {{"on", true}, {"off", false}};
const Words<NormalGain> kNormals = {{"paper", NormalGain::kPaper},
                                    {"harmonic", NormalGain::kHarmonic}};
const Words<PairWeights> kWeights = {{"triangle", PairWeights::kTriangle},
                                     {"tetrahedron", PairWeights::kTetrahedron}};
const Words<DepthRule> kDepth = {{"projection", DepthRule::kProjection},
                                 {"consistent", DepthRule::kConsistent}};
const Words<PairFace> kFace = {{"nearest", PairFace::kNearest}, {"opposed", PairFace::kOpposed}};
const Words<PairKey> kKey = {{"body", PairKey::kBody}, {"triangle", PairKey::kTriangle}};
const Words<bool> kBound = {{"transmitted", false}, {"literal", true}};
const Words<bool> kOrder = {{"normals-first", true}, {"interleaved", false}};
const Words<Integrator> kIntegrator = {{"symplectic-euler", Integrator::kSymplecticEuler},
                                       {"verlet", Integrator::kVerlet}};
const Words<bool> kMemory = {{"keep", true}, {"reset", false}};

template <class Value>
std::string word_of(const Words<Value>& words, Value value) {
  for (const auto& [word, meaning] : words) {
    if (meaning == value) return word;
  }
  demand(false, "every value of a setting has a word");
  return {};
}

template <class Value>
void read_word(SettingsReader& reader, const std::string& name, const Words<Value>& words,
               Value& value) {
  const std::string given = reader.text(name, word_of(words, value));
  std::string known;
  for (const auto& [word, meaning] : words) {
    if (word == given) {
      value = meaning;
      return;
    }
    known += (known.empty() ? "" : ", ") + word;
  }
  throw InputError(fmt::format("setting '{}' is one of {}, not '{}'", name, known, given));
}

// Whether a rule turns the last step's slip into memory (then it has a gain), rather than storing
// forces.
bool rule_learns(const std::string& name) {
  bool learns = false;
  with_friction_rule(name, {}, [&](const auto& rule) {
    using Rule = std::decay_t<decltype(rule)>;
    learns = Rule::kValues > 0 && !Rule::kWarmStart;
  });
  return learns;
}

Options preset(const std::string& method) {
  Options options;
  if (method == "quiet") return options;
  PairOptions& pairs = options.pairs;
  pairs.gain = NormalGain::kPaper;
  pairs.weights = PairWeights::kTriangle;
  pairs.normals_first = false;
  pairs.face = PairFace::kNearest;
  pairs.edges = false;
  pairs.hysteresis = 0.0;
  pairs.tie_margin = 0.0;
  pairs.border_margin = 0.0;
  if (method == "paper") {
    options.rule = "fixed-point";
    pairs.depth = DepthRule::kConsistent;
    return options;
  }
  if (method != "old") {
    throw InputError("setting 'method' is one of old, paper, quiet, not '" + method + "'");
  }
  options.rule = "none";
  pairs.post_correction = false;
  pairs.friction_reaction = false;
  return options;
}

}  // namespace

void read_method(SettingsReader& reader, Options& options) {
  const double time_step = options.time_step;
  options = preset(reader.text("method", "quiet"));
  options.time_step = time_step;
  options.rule = reader.text("rule", options.rule);
  if (!is_friction_rule(options.rule)) {
    throw InputError(fmt::format("unknown friction rule '{}'; there are: {}", options.rule,
                                 friction_rule_list()));
  }
  options.sweeps = reader.count("sweeps", options.sweeps);
  read_word(reader, "integrator", kIntegrator, options.integrator);
  FrictionParameters& friction = options.friction;
  friction.gain = reader.number("gain", friction.gain);
  friction.raw_alpha = reader.number("alpha", friction.raw_alpha);
  friction.relaxation = reader.number("relaxation", friction.relaxation);
  friction.slip_tolerance = reader.number("slip-tolerance", friction.slip_tolerance);
  read_word(reader, "memory", kMemory, friction.keep_through_slip);
  read_word(reader, "safeguard", kSwitch, friction.safeguard);
  PairOptions& pairs = options.pairs;
  read_word(reader, "normals", kNormals, pairs.gain);
  pairs.harmonic_gain = reader.number("kappa", pairs.harmonic_gain);
  read_word(reader, "weights", kWeights, pairs.weights);
  read_word(reader, "depth", kDepth, pairs.depth);
  read_word(reader, "face", kFace, pairs.face);
  read_word(reader, "key", kKey, pairs.key);
  read_word(reader, "edges", kSwitch, pairs.edges);
  read_word(reader, "post-correction", kSwitch, pairs.post_correction);
  read_word(reader, "reaction", kSwitch, pairs.friction_reaction);
  read_word(reader, "bound", kBound, pairs.literal_bound);
  read_word(reader, "order", kOrder, pairs.normals_first);
  pairs.hysteresis = reader.number("hysteresis", pairs.hysteresis);
  pairs.tie_margin = reader.number("tie", pairs.tie_margin);
  pairs.border_margin = reader.number("border", pairs.border_margin);
  pairs.depth_noise = reader.number("depth-noise", pairs.depth_noise);
  read_word(reader, "count-hysteresis", kSwitch, pairs.count_hysteresis);
}

Settings method_settings(const Options& options, bool with_pairs) {
  Settings all{{"rule", options.rule}};
  const FrictionParameters& friction = options.friction;
  if (options.integrator != Integrator::kSymplecticEuler) {
    all["integrator"] = word_of(kIntegrator, options.integrator);
  }
  const int sweeps = options.sweeps > 0 ? options.sweeps : friction_rule_card(options.rule).sweeps;
  if (sweeps > 1) all["sweeps"] = fmt::format("{}", sweeps);
  const bool learns = rule_learns(options.rule);
  if (learns) {
    const bool raw = friction.raw_alpha != 0.0 && options.rule == "fixed-point";
    all[raw ? "alpha" : "gain"] = fmt::format("{}", raw ? friction.raw_alpha : friction.gain);
    all["memory"] = word_of(kMemory, friction.keep_through_slip);
  }
  if (options.rule == "secant") all["safeguard"] = word_of(kSwitch, friction.safeguard);
  if (options.rule == "conjugate-vector") {
    all["slip-tolerance"] = fmt::format("{}", friction.slip_tolerance);
  }
  if (!learns && options.rule != "none" && friction.relaxation != 1.0) {
    all["relaxation"] = fmt::format("{}", friction.relaxation);
  }
  if (!with_pairs) return all;
  const PairOptions& pairs = options.pairs;
  all["normals"] = word_of(kNormals, pairs.gain);
  if (pairs.gain == NormalGain::kHarmonic) all["kappa"] = fmt::format("{}", pairs.harmonic_gain);
  all["weights"] = word_of(kWeights, pairs.weights);
  all["depth"] = word_of(kDepth, pairs.depth);
  all["face"] = word_of(kFace, pairs.face);
  all["edges"] = word_of(kSwitch, pairs.edges);
  all["key"] = word_of(kKey, pairs.key);
  all["post-correction"] = word_of(kSwitch, pairs.post_correction);
  all["reaction"] = word_of(kSwitch, pairs.friction_reaction);
  all["order"] = word_of(kOrder, pairs.normals_first);
  all["hysteresis"] = fmt::format("{}", pairs.hysteresis);
  all["tie"] = fmt::format("{}", pairs.tie_margin);
  all["border"] = fmt::format("{}", pairs.border_margin);
  if (pairs.depth_noise > 0.0) all["depth-noise"] = fmt::format("{}", pairs.depth_noise);
  if (pairs.literal_bound) all["bound"] = word_of(kBound, true);
  if (pairs.hysteresis > 0.0 && !pairs.count_hysteresis) all["count-hysteresis"] = "off";
  return all;
}

std::map<std::string, std::string> method_settings_help() {
  return {
      {"method", "preset of all below: quiet (default), paper, old"},
      {"rule", "friction rule: " + friction_rule_list() +
                   " (quiet: conjugate-vector, a nonsmooth nonlinear conjugate gradient; "
                   "stored-vector is a warm-started projected Gauss–Seidel iteration)"},
      {"integrator", "symplectic-euler (default) or verlet"},
      {"sweeps",
       "iterations over all contacts in the friction phase; conjugate-vector: at most (default: 1; "
       "64 "
       "of conjugate-vector)"},
      {"gain", "g of the rules that learn from slip, dimensionless (default 0.7)"},
      {"alpha", "the paper's raw α, s/m, in place of g"},
      {"relaxation", "ω of the rules that store forces, dimensionless (default 1)"},
      {"slip-tolerance",
       "of conjugate-vector: the slip, in gΔt, whose removal ends its sweeps (default 1e-7)"},
      {"memory", "ξ or c on slip: reset (default) or keep"},
      {"safeguard", "of secant: on (default) or off"},
      {"normals", "normal forces: harmonic (quiet) or paper"},
      {"kappa", "κ₀ of harmonic, dimensionless (default 1)"},
      {"weights", "where reactions act: tetrahedron (quiet) or triangle (paper)"},
      {"depth", "projection (quiet, old) or consistent (paper, sec. 3.2)"},
      {"face",
       "what a depth is measured to: the nearest face, or opposed (quiet): the nearest of those "
       "that the vertex can rest on"},
      {"border",
       "how far beyond the border of its face a contact is kept, in mean edges (quiet: 1e-3; "
       "paper: 0)"},
      {"edges", "contacts of crossing edges, with normals=harmonic: on (quiet) or off (paper)"},
      {"key", "of a contact's memory: body (default) or triangle"},
      {"post-correction", "on (default) or off (old)"},
      {"reaction", "friction on the partners: on (default) or off (old)"},
      {"bound", "μ times what force: transmitted (default) or literal"},
      {"order", "normals-first (quiet) or interleaved (paper)"},
      {"hysteresis", "gap up to which a contact is kept, in |g|Δt² (quiet: 20; paper: 0)"},
      {"depth-noise", "error of each depth in each step, of the depth (default 0)"},
      {"tie",
       "how much farther than the nearest a contact's triangle may be to be kept, of the "
       "depth (quiet: 1e-3; paper: 0)"},
      {"count-hysteresis", "kept contacts count in κ: on (default) or off"},
  };
}

}  // namespace stiction
