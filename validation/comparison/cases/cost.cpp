// SPDX-License-Identifier: GPL-3.0-or-later
// What a rule costs per contact, against the fixed point in the same run: both advance in turn, so
// that a noisy machine disturbs both.
#include "reference/statistics/two_samples.h"
#include "validation/comparison/comparison.h"
#include "validation/comparison/comparison_table.h"
#include "validation/comparison/scenes.h"

namespace stiction {

namespace {

constexpr int kRounds = 15, kStepsARound = 64;
constexpr std::uint64_t kToRest = 4000;  // steps: vibration has sunk below what rules still see

double friction_seconds(const Cost& cost) { return cost.phase_seconds.at("friction"); }

void run_cost(CaseRun& run, const ComparisonScene& scene) {
  const Snapshot start =
      settled_without_memory(run.engine(), scene, contacts_of(run.settings())).state;
  const auto own = run.simulate_with(scene.settings, scene.problem);
  Settings settings = scene.settings;
  settings["method"] = run.settings().at("method");
  settings["rule"] = "fixed-point";
  const auto fixed_point = run.engine().make(settings);
  fixed_point->load(scene.problem, {});
  own->engine().restore(start);
  fixed_point->restore(start);
  // Nanoseconds a contact of the next steps.
  const auto advance = [](Engine& engine) {
    const Cost before = engine.cost();
    engine.advance(kStepsARound);
    const Cost after = engine.cost();
    return 1e9 * (friction_seconds(after) - friction_seconds(before)) /
           static_cast<double>(after.contact_updates - before.contact_updates);
  };
  // Medians of the rounds: this rule's nanoseconds, and their ratio to the fixed point's.
  const auto compare = [&] {
    advance(own->engine());
    advance(*fixed_point);
    std::vector<double> times, ratios;
    for (int k = 0; k < kRounds; ++k) {
      const double mine = advance(own->engine());
      times.push_back(mine);
      ratios.push_back(mine / advance(*fixed_point));
    }
    return std::pair(reference::median(times), reference::median(ratios));
  };
  const auto [time, ratio] = compare();
  run.add(Figure{kFrictionTime, "ns", "median of 15 rounds, memory just lost", time});
  run.add(Figure{kFrictionRatio, "1", "median of the ratios", ratio});
  // Only a rule that comes to rest, and there does less, has a cost at rest of its own.
  const std::string rule = run.settings().at("rule");
  if (run.settings().at("method") == "quiet" && rule.find("-vector") != std::string::npos &&
      rule != "bias-vector") {
    own->engine().advance(kToRest);
    run.add(Figure{"… at rest", "1", "median of the ratios", compare().second});
  }
  run.add(Figure{"contacts", "1", "that were timed",
                 static_cast<double>(own->engine().contacts().size())});
}

}  // namespace

std::vector<Case> comparisons_cost() {
  const ComparisonScene scene = comparison_plate();
  return {{.name = "cost/plate",
           .title = scene.title,
           .variants = all_rules(),
           .run = [scene](CaseRun& run) { run_cost(run, scene); }}};
}

}  // namespace stiction
