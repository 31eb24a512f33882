// SPDX-License-Identifier: GPL-3.0-or-later
// Flat plates flush on each other, the topmost as dense as the others or much denser.
#include <fmt/format.h>

#include <vector>

#include "validation/observe/rest_watch.h"
#include "validation/problems/piles/stack_problem.h"

namespace stiction {

namespace {

StackSetup plates(double top_density) {
  StackSetup setup;
  setup.boxes = 3;
  setup.size = Vec3(0.2, 0.2, 0.05);
  setup.cells = 2;
  setup.ground = Ground::kSlab;
  setup.top_density = top_density;
  setup.tan_slope = 0.2;
  return setup;
}

void run_plates(CaseRun& run, const StackSetup& setup, const Asked& asked) {
  const RestScene scene{.words = fmt::format("top {:g} times as dense", setup.top_density),
                        .problem = stack_problem(setup),
                        .settled = kStackSettled};
  check_rest(
      run, watch_rest(run, scene, asked, 0.5 * setup.size.x()),
      {.drift_reason = "the paper's 1e-9 m/s of static contacts over the window of 10 s",
       .slip_reason = "vibration has decayed and the medium it settled in is gone; round-off "
                      "of velocities of g Δt = 2e-3 m/s leaves some hundred roundings of "
                      "4e-19 m/s",
       .claim = "flush plates rest under a top of any density"});
}

}  // namespace

std::vector<Case> cases_stack_plates() {
  std::vector<Case> cases;
  for (const double top : {1.0, 10.0, 100.0}) {
    const std::string name = fmt::format("stack/plates/top={:g}", top);
    const std::string title =
        fmt::format("three flush plates rest at tan θ = 0.2, the top {:g} times as dense", top);
    cases.push_back({.name = name, .title = title, .set = CaseSet::kFull, .run = [=](CaseRun& run) {
                       run_plates(run, plates(top), kOnce);
                     }});
    cases.push_back({.name = name + "/doubled",
                     .title = title + ", in twice the window, with half the step",
                     .set = CaseSet::kFull,
                     .run = [=](CaseRun& run) { run_plates(run, plates(top), kDoubled); }});
  }
  return cases;
}

}  // namespace stiction
