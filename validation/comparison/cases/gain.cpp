// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's sweep of α, here over six decades and both signs (a reading in millimetres is a
// thousand times as large as one in metres), and the same over the dimensionless gain.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "validation/comparison/comparison.h"
#include "validation/comparison/rule_history.h"

namespace stiction {

namespace {

constexpr std::uint64_t kSteps = 1000;

struct Sweep {
  std::string setting;  // of the engine
  std::string unit;
  std::vector<double> values;
};

// Both signs, `a_decade` from 10^`from` to 10^`to`, and 0.
std::vector<double> over_decades(int from, int to, int a_decade) {
  std::vector<double> positive;
  for (int k = from * a_decade; k <= to * a_decade; ++k) {
    positive.push_back(std::pow(10.0, static_cast<double>(k) / a_decade));
  }
  std::vector<double> values;
  for (auto value = positive.rbegin(); value != positive.rend(); ++value) {
    values.push_back(-*value);
  }
  values.push_back(0.0);
  values.insert(values.end(), positive.begin(), positive.end());
  return values;
}

std::vector<double> evenly(double from, double to, int points) {
  std::vector<double> values;
  for (int k = 0; k < points; ++k) values.push_back(from + (to - from) * k / (points - 1));
  return values;
}

void run_sweep(CaseRun& run, ComparisonScene scene, const Sweep& sweep) {
  scene.steps = kSteps;
  Series creep{"final creep", "m/s", sweep.setting, sweep.unit, {}, {}};
  double best = std::numeric_limits<double>::infinity(), best_at = std::nan("");
  std::vector<double> failed;
  const RuleHistory usual = run_rule(run, scene);
  bool same_hash = usual.same_hash;
  for (const double value : sweep.values) {
    // α = 0 would mean the gain; both 0 are ξ = 1 for ever.
    const bool is_zero = std::abs(value) < 1e-12;
    const std::string setting = is_zero ? "gain" : sweep.setting;
    const RuleHistory history =
        run_rule(run, scene, {{setting, is_zero ? "0" : fmt::format("{:.12g}", value)}});
    same_hash = same_hash && history.same_hash;
    if (!history.failure.empty()) {
      failed.push_back(value);
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
  run.add(Figure{"least final creep", "m/s", "what is held does not creep", best});
  run.add(Figure{"best " + sweep.setting, sweep.unit, "where that is", best_at});
  run.add(Figure{"final creep at the default gain", "m/s", "what is held does not creep",
                 usual.creep()});
  run.add(Figure{"failures", "1", "no value throws the box off",
                 static_cast<double>(sweep.values.size() - creep.x.size())});
  if (!failed.empty()) run.add(Failure{"a body left its place", sweep.setting, failed});
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
          .title = fmt::format("creep over {} from {:g} to {:g}, {}", sweep.setting,
                               sweep.values.front(), sweep.values.back(), scene.title),
          .variants = variants,
          .run = [=](CaseRun& run) { run_sweep(run, scene, sweep); }};
}

}  // namespace

std::vector<Case> comparisons_gain() {
  const Sweep alpha{"alpha", "s/m", over_decades(-3, 3, 2)};
  const Sweep gain{"gain", "1", evenly(-0.5, 2.5, 16)};
  std::vector<Case> cases;
  for (const ComparisonScene& scene : comparison_scenes()) {
    if (scene.name != "slab" && scene.name != "box-pyramid") continue;
    cases.push_back(sweep_case(scene, alpha, {"fixed-point"}));
    cases.push_back(sweep_case(scene, gain, {"fixed-point", "secant", "bias-vector"}));
  }
  return cases;
}

}  // namespace stiction
