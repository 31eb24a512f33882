// SPDX-License-Identifier: GPL-3.0-or-later
// Cubes exactly on each other: vertices on vertices, edges on edges, side walls in one plane.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "validation/observe/rest_watch.h"
#include "validation/problems/piles/stack_problem.h"

namespace stiction {

namespace {

struct Slope {
  std::string word;
  double degrees = 0.0;         // where it is given so
  double share_of_limit = 0.0;  // … or else
};

RestBounds stack_bounds() {
  return {
      .drift_reason = "the paper's 1e-9 m/s of static contacts over the window of 10 s",
      .slip_reason =
          "vibration has decayed and the medium it settled in is gone; round-off of "
          "velocities of g Δt = 2e-3 m/s leaves some hundred roundings of 4e-19 m/s",
      .source = "static equilibrium below the limit load (limit analysis; column without tension)",
      .claim = "a flush stack rests as a shifted one does"};
}

void run_stack(CaseRun& run, StackSetup setup, const Slope& slope, const Asked& asked) {
  const StackLimit limit = critical_tan(setup);
  setup.tan_slope = slope.share_of_limit > 0.0 ? slope.share_of_limit * limit.elastic
                                               : std::tan(slope.degrees * std::numbers::pi / 180.0);
  run.note(
      fmt::format("tan θ = {:.4f}; the rigid stack slides or topples at {:.4f} (limit "
                  "analysis), an elastic column without tension by its lean at {:.4f}",
                  setup.tan_slope, limit.rigid, limit.elastic));
  const RestScene scene{
      .words = stack_words(setup), .problem = stack_problem(setup), .settled = kStackSettled};
  check_rest(run, watch_rest(run, scene, asked, 0.5 * setup.size.x()), stack_bounds());
}

}  // namespace

std::vector<Case> cases_stack_flush() {
  const std::vector<Slope> slopes = {
      {"slope=0", 0.0, 0.0}, {"slope=2", 2.0, 0.0}, {"slope=90%", 0.0, 0.9}};
  std::vector<Case> cases;
  for (const Ground ground : {Ground::kRigid, Ground::kSlab, Ground::kFlush}) {
    for (const Slope& slope : slopes) {
      for (const int boxes : {2, 5, 7, 10}) {
        StackSetup setup;
        setup.boxes = boxes;
        setup.ground = ground;
        const std::string name =
            fmt::format("stack/flush/{}/{}/n={}", word(ground), slope.word, boxes);
        const std::string title = fmt::format("{} cubes flush on each other rest ({}, {})", boxes,
                                              word(ground), slope.word);
        // Two cubes everywhere; seven near what they bear, where they lean most, on every ground
        // and level on the slab; the highest on the slab at 2°.
        const bool slab = ground == Ground::kSlab;
        const bool chosen = boxes == 2 || (boxes == 7 && slope.share_of_limit > 0.0) ||
                            (slab && boxes == 7 && slope.degrees == 0.0) ||
                            (slab && boxes == 10 && slope.degrees == 2.0);
        cases.push_back({.name = name,
                         .title = title,
                         .set = chosen ? CaseSet::kDefault : CaseSet::kFull,
                         .run = [=](CaseRun& run) { run_stack(run, setup, slope, kOnce); }});
        cases.push_back({.name = name + "/doubled",
                         .title = title + ", in twice the window, with half the step",
                         .set = CaseSet::kFull,
                         .run = [=](CaseRun& run) { run_stack(run, setup, slope, kDoubled); }});
        setup.cells = 2;
        cases.push_back({.name = name + "/cells=2",
                         .title = title + ", two cells an edge",
                         .set = CaseSet::kFull,
                         .run = [=](CaseRun& run) { run_stack(run, setup, slope, kOnce); }});
      }
    }
  }
  return cases;
}

}  // namespace stiction
