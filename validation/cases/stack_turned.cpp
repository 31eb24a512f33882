// SPDX-License-Identifier: GPL-3.0-or-later
// Ten cubes on each other, each turned a little further about the vertical.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "validation/observe/rest_watch.h"
#include "validation/problems/piles/stack_problem.h"

namespace stiction {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

StackSetup turned(double turn, int cells) {
  StackSetup setup;
  setup.boxes = 10;
  setup.cells = cells;
  setup.ground = Ground::kSlab;
  setup.tan_slope = std::tan(2.0 * kDegree);
  for (int k = 0; k < setup.boxes; ++k) setup.turns.push_back(turn * (k + 1));
  return setup;
}

void run_turned(CaseRun& run, const std::vector<double>& turns, int cells, const Asked& asked) {
  std::vector<RestOutcome> outcomes;
  for (const double turn : turns) {
    const StackSetup setup = turned(turn, cells);
    const RestScene scene{.words = fmt::format("turned by {:.1f}° a cube", turn / kDegree),
                          .problem = stack_problem(setup),
                          .settled = kStackSettled};
    for (RestOutcome& outcome :
         watch_rest(run, scene, asked, 0.5 * setup.size.x(), outcomes.empty())) {
      outcomes.push_back(std::move(outcome));
    }
  }
  check_rest(
      run, outcomes,
      {.drift_reason = "the paper's 1e-9 m/s of static contacts over the window of 10 s",
       .slip_reason = "vibration has decayed and the medium it settled in is gone; round-off "
                      "of velocities of g Δt = 2e-3 m/s leaves some hundred roundings of "
                      "4e-19 m/s",
       .claim = "a stack of turned cubes rests at 2°"});
}

}  // namespace

std::vector<Case> cases_stack_turned() {
  // Ten turns a cube, from nearly flush to an eighth of a full turn.
  std::vector<double> ten;
  for (const double degrees : {1.0, 3.0, 5.0, 7.0, 10.0, 15.0, 20.0, 25.0, 35.0, 45.0}) {
    ten.push_back(degrees * kDegree);
  }
  const auto stack = [](const std::string& name, const std::string& title, CaseSet set,
                        const std::vector<double>& turns, int cells, const Asked& asked) {
    return Case{
        .name = "stack/turned/" + name, .title = title, .set = set, .run = [=](CaseRun& run) {
          run_turned(run, turns, cells, asked);
        }};
  };
  return {stack("cells=1", "ten cubes, each turned 1° or 7° further than the one below, rest at 2°",
                CaseSet::kDefault, {1.0 * kDegree, 7.0 * kDegree}, 1, kOnce),
          stack("cells=2", "ten turned cubes rest at 2°, two cells an edge", CaseSet::kFull,
                {7.0 * kDegree}, 2, kOnce),
          stack("ten", "ten stacks of ten turned cubes rest at 2°", CaseSet::kFull, ten, 1, kOnce),
          stack("cells=2/doubled", "ten turned cubes rest, in twice the window, with half the step",
                CaseSet::kFull, {7.0 * kDegree}, 2, kDoubled)};
}

}  // namespace stiction
