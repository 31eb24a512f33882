// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/stiction/stiction_method.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "reports/text/names.h"
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
  for (const auto& [word, meaning] : words) {
    if (word == given) {
      value = meaning;
      return;
    }
  }
  throw InputError(fmt::format("setting '{}' is one of {}, not '{}'", name,
                               listed_names(words, [](const auto& one) { return one.first; }),
                               given));
}

double read_parameter(SettingsReader& reader, const RuleParameter& parameter) {
  if (!parameter.off) return reader.number(parameter.name, parameter.initial);
  double value = parameter.initial;
  read_word(reader, parameter.name, Words<double>{{parameter.off, 0.0}, {parameter.on, 1.0}},
            value);
  return value;
}

// Those of the rule that were given. The names of the other rules' are known too, so that one set of
// settings can be laid over several rules; idle_settings() says what that leaves without effect.
RuleSettings read_parameters(SettingsReader& reader, const std::string& chosen) {
  RuleSettings given;
  for (const std::string& rule : friction_rule_names()) {
    for (const RuleParameter& parameter : friction_rule_parameters(rule)) {
      if (!reader.has(parameter.name) || rule != chosen) continue;
      given[parameter.name] = read_parameter(reader, parameter);
    }
  }
  return given;
}

std::string text_of(const RuleParameter& parameter, double value) {
  if (parameter.off) return value != 0.0 ? parameter.on : parameter.off;
  return fmt::format("{}", value);
}

// What each parameter is, and of which rules.
std::map<std::string, std::string> parameters_help() {
  std::map<std::string, std::map<std::string, std::string>> rules_of;  // name → words → rules
  for (const std::string& rule : friction_rule_names()) {
    for (const RuleParameter& one : friction_rule_parameters(rule)) {
      std::string& rules = rules_of[one.name][parameter_help(one)];
      rules += (rules.empty() ? "" : ", ") + rule;
    }
  }
  std::map<std::string, std::string> help;
  for (const auto& [name, meanings] : rules_of) {
    for (const auto& [words, rules] : meanings) {
      help[name] += fmt::format("{}{}; of {}", help[name].empty() ? "" : "; ", words, rules);
    }
  }
  return help;
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
  options.friction = read_parameters(reader, options.rule);
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

std::string parameter_help(const RuleParameter& parameter) {
  const std::string unit =
      parameter.unit == std::string("1") ? "" : fmt::format(", {}", parameter.unit);
  return fmt::format("{}{}: {} (default {})", parameter.help, unit, range_words(parameter),
                     text_of(parameter, parameter.initial));
}

Settings rule_settings(const Options& options) {
  Settings all{{"rule", options.rule}};
  const auto parameters = friction_rule_parameters(options.rule);
  for (const RuleParameter& parameter : parameters) {
    const double value = value_of(parameter, options.friction);
    if (parameter.told_when_set && value == parameter.initial) continue;
    all[parameter.name] = text_of(parameter, value);
  }
  for (const RuleParameter& parameter : parameters) {
    if (parameter.replaces && value_of(parameter, options.friction) != parameter.initial) {
      all.erase(parameter.replaces);
    }
  }
  return all;
}

std::map<std::string, std::string> idle_settings(const Settings& settings) {
  Options options;
  SettingsReader reader(settings);
  read_method(reader, options);
  std::map<std::string, std::string> idle;
  for (const auto& [name, help] : parameters_help()) {
    if (settings.count(name) == 0 || options.friction.count(name) > 0) continue;
    idle[name] = refusal_of(options.rule, friction_rule_parameters(options.rule), {{name, 0.0}});
  }
  return idle;
}

Settings method_settings(const Options& options, bool with_pairs) {
  Settings all = rule_settings(options);
  if (options.integrator != Integrator::kSymplecticEuler) {
    all["integrator"] = word_of(kIntegrator, options.integrator);
  }
  const int sweeps = options.sweeps > 0 ? options.sweeps : friction_rule_card(options.rule).sweeps;
  if (sweeps > 1) all["sweeps"] = fmt::format("{}", sweeps);
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
  std::map<std::string, std::string> help{
      {"method", "preset of all below: quiet (default), paper, old"},
      {"rule", "friction rule: " + friction_rule_list() +
                   " (quiet: conjugate-vector, a nonsmooth nonlinear conjugate gradient; "
                   "stored-vector is a warm-started projected Gauss–Seidel iteration)"},
      {"integrator", "symplectic-euler (default) or verlet"},
      {"sweeps",
       "iterations over all contacts in the friction phase; conjugate-vector: at most (default: 1; "
       "64 "
       "of conjugate-vector)"},
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
      {"hysteresis",
       "gap up to which a contact is kept, in |g|Δt T, with T the time in which a wave passes the "
       "slowest body that can move, at least 20 Δt; never over a hundredth of a mean edge (quiet: "
       "1; paper: 0)"},
      {"depth-noise", "error of each depth in each step, of the depth (default 0)"},
      {"tie",
       "how much farther than the nearest a contact's triangle may be to be kept, of the "
       "depth (quiet: 1e-3; paper: 0)"},
      {"count-hysteresis", "kept contacts count in κ: on (default) or off"},
  };
  for (const auto& [name, words] : parameters_help()) {
    demand(help.emplace(name, words).second, "a rule's parameter has the name of another setting");
  }
  return help;
}

}  // namespace stiction
