// SPDX-License-Identifier: GPL-3.0-or-later
// Work and precision: what is slipped in the same 0.2 s over the CPU time that they took, with the
// time step, the mesh and the gain as parameters, in double and in single precision.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "validation/comparison/comparison.h"
#include "validation/comparison/rule_history.h"

namespace stiction {

namespace {

constexpr double kWindow = 0.2;  // s

void run_work(CaseRun& run, const ComparisonScene& scene, double slope) {
  const double free_slide = 0.5 * kStandardGravity * std::sin(slope) * kWindow * kWindow;
  const RuleHistory history = run_rule(run, scene);
  check_same_hash(run, history.same_hash);
  run.add(Figure{kSlippedShare, "1", "little is lost before friction is found",
                 history.failure.empty() ? history.path() / free_slide
                                         : std::numeric_limits<double>::infinity()});
  run.add(Figure{kCpuTime, "s", "little work", run.record().cost.cpu_seconds});
  run.add(Figure{kCreep, "m/s", "what is held does not creep", history.creep()});
  if (!history.failure.empty()) run.add(Failure{history.failure});
}

std::vector<Settings> work_variants() {
  std::vector<Settings> variants = chief_rules();
  for (const char* method : {"paper", "quiet"}) {
    variants.push_back({{"method", method}, {"rule", "none"}});
    for (const char* gain : {"0.3", "1.2"}) {
      variants.push_back({{"method", method}, {"rule", "fixed-point"}, {"gain", gain}});
    }
  }
  return variants;
}

// Each chief rule's row in single precision right behind it in double, so that what disturbs the
// machine disturbs both.
std::vector<Settings> with_single_precision(const std::vector<Settings>& all) {
  const std::vector<Settings> chief = chief_rules();
  std::vector<Settings> variants;
  for (const Settings& one : all) {
    variants.push_back(one);
    if (std::find(chief.begin(), chief.end(), one) == chief.end()) continue;
    variants.push_back(one);
    variants.back()[kBuild] = "single";
  }
  return variants;
}

Case work_case(const std::string& name, const std::string& title, ComparisonScene scene,
               double slope, const std::string& dt) {
  scene.settings["dt"] = dt;
  scene.steps = static_cast<std::uint64_t>(std::lround(kWindow / std::stod(dt)));
  return {.name = name,
          .title = title,
          .variants = with_single_precision(work_variants()),
          .run = [=](CaseRun& run) { run_work(run, scene, slope); }};
}

}  // namespace

std::vector<Case> comparisons_work() {
  std::vector<Case> cases;
  for (const char* dt : {"2e-4", "1e-4", "5e-5"}) {
    for (const int cells : {2, 3, 4}) {
      SlabSetup setup = comparison_slab();
      setup.cells = cells;
      setup.slab_cells = cells + 1;
      const ComparisonScene scene{.name = "work-slab",
                                  .title = "",
                                  .problem = slab_problem(setup),
                                  .settings = {{"cells", fmt::format("{}", cells)}},
                                  .settled = 2.0,
                                  .size = setup.box_size.x()};
      cases.push_back(work_case(fmt::format("work/slab/cells={}/dt={}", cells, dt),
                                "a box on a deformable slab", scene, setup.slope, dt));
      cases.back().title += fmt::format(", {} cells an edge, Δt {} s", cells, dt);
    }
  }
  return cases;
}

}  // namespace stiction
