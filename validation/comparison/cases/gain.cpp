// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's sweep of α over [−1, 1], and the same over the dimensionless gain.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "validation/comparison/comparison.h"
#include "validation/comparison/history.h"

namespace stiction {

namespace {

constexpr std::uint64_t kSteps = 1000;

struct Sweep {
  std::string setting;  // of the engine
  std::string unit;
  double from, to;
  int points;
};

void run_sweep(CaseRun& run, ComparisonScene scene, const Sweep& sweep) {
  scene.steps = kSteps;
  Series creep{"final creep", "m/s", sweep.setting, sweep.unit, {}, {}};
  double best = std::numeric_limits<double>::infinity(), best_at = std::nan("");
  std::string failed;
  const RuleHistory usual = run_rule(run, scene);
  bool same_hash = usual.same_hash;
  for (int k = 0; k < sweep.points; ++k) {
    const double value = sweep.from + (sweep.to - sweep.from) * k / (sweep.points - 1);
    // α = 0 would mean the gain; both 0 are ξ = 1 for ever.
    const bool is_zero = std::abs(value) < 1e-12;
    const std::string setting = is_zero ? "gain" : sweep.setting;
    const RuleHistory history =
        run_rule(run, scene, {{setting, is_zero ? "0" : fmt::format("{:.12g}", value)}});
    same_hash = same_hash && history.same_hash;
    if (!history.failure.empty()) {
      failed += fmt::format("{}{:g}", failed.empty() ? "" : ", ", value);
      continue;
    }
    creep.x.push_back(value);
    creep.y.push_back(history.creep());
    if (history.creep() < best) {
      best = history.creep();
      best_at = value;
    }
  }
  check_same_hash(run, same_hash);
  run.check(measured("least final creep", "m/s", "what is held does not creep", best));
  run.check(measured("best " + sweep.setting, sweep.unit, "where that is", best_at));
  run.check(measured("final creep at the default gain", "m/s", "what is held does not creep",
                     usual.creep()));
  run.check(measured("failures", "1", "no value throws the box off",
                     static_cast<double>(sweep.points) - static_cast<double>(creep.x.size())));
  if (!failed.empty()) run.note("failed: " + sweep.setting + " = " + failed);
  run.add(std::move(creep));
}

Case sweep_case(const ComparisonScene& scene, const Sweep& sweep,
                const std::vector<std::string>& rules) {
  std::vector<Settings> variants;
  for (const char* method : {"paper", "quiet"}) {
    for (const std::string& rule : rules) {
      variants.push_back({{"method", method}, {"rule", rule}, {"memory", "keep"}});
    }
  }
  return {.name = sweep.setting + "/" + scene.name,
          .title = fmt::format("creep over {} from {:g} to {:g}, {}", sweep.setting, sweep.from,
                               sweep.to, scene.title),
          .variants = variants,
          .run = [=](CaseRun& run) { run_sweep(run, scene, sweep); }};
}

}  // namespace

std::vector<Case> comparisons_gain() {
  const Sweep alpha{"alpha", "s/m", -1.0, 1.0, 21};
  const Sweep gain{"gain", "1", -0.5, 2.5, 16};
  std::vector<Case> cases;
  for (const ComparisonScene& scene : comparison_scenes()) {
    if (scene.name != "slab" && scene.name != "box-pyramid") continue;
    cases.push_back(sweep_case(scene, alpha, {"fixed-point"}));
    cases.push_back(sweep_case(scene, gain, {"fixed-point", "secant", "bias-vector"}));
  }
  return cases;
}

}  // namespace stiction
