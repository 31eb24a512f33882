// SPDX-License-Identifier: GPL-3.0-or-later
// A box partly over the edge of its support.
#include <fmt/format.h>

#include "validation/problems/gauntlet/cliff_problem.h"
#include "validation/protocols/gauntlet_rest.h"

namespace stiction {

namespace {

const char* const kCliffSource =
    "statics: a box stays iff its centre of mass lies over the support";

void run_stays(CaseRun& run) {
  std::vector<std::pair<std::string, Problem>> scenes;
  for (const auto& [inside, yaw] : {std::pair{0.005, 0.0}, {0.02, 0.0}, {0.005, 30.0}}) {
    const CliffSetup setup{.inside = inside, .yaw = yaw};
    scenes.emplace_back(cliff_words(setup), cliff_problem(setup));
  }
  check_gauntlet_rest(run, scenes,
                      {.claim = "a box partly over an edge stays",
                       .source = kCliffSource,
                       .settled = 2.2,
                       .given_up = 0.005});
}

// A rigid box that begins to turn about the edge does so by α = g d/(k² + d² + h²/4), d beyond it,
// 36 1/s²: by 1 rad within 0.4 s of full gravity.
void run_falls(CaseRun& run) {
  constexpr double kUntil = 1.0, kTilt = 0.5;  // s, rad
  int stayed = 0;
  std::string words;
  for (const double yaw : {0.0, 30.0}) {
    const CliffSetup setup{.inside = -0.005, .yaw = yaw, .drag = {}};
    const Problem problem = cliff_problem(setup);
    const auto simulation = run.simulate(problem);
    simulation->record_frames(0.01);
    double tilt = 0.0;
    while (simulation->time() < kUntil && tilt < kTilt) {
      simulation->advance_to(simulation->time() + 0.01);
      const Vec3 up = simulation->engine().body(0).rotation * Vec3::UnitZ();
      tilt = std::acos(std::min(1.0, up.z()));
    }
    run.note(fmt::format("{}: tilted by {:.2f} rad at {:.2f} s", cliff_words(setup), tilt,
                         simulation->time()));
    if (tilt < kTilt && stayed++ == 0) words = "first: " + cliff_words(setup);
  }
  run.check({.quantity = "boxes that stay",
             .unit = "1",
             .statement = "a box whose centre of mass lies beyond the edge tips over it",
             .formula = "tilt ≥ 0.5 rad within 1 s",
             .source = kCliffSource,
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 0.0,
             .reason = "a count; 5 mm beyond the edge a rigid box starts with 36 rad/s²"},
            stayed, words);
}

}  // namespace

std::vector<Case> cases_gauntlet_cliff() {
  return {{.name = "gauntlet/cliff/stays",
           .title = "a box whose centre lies 5 mm inside an edge stays",
           .set = CaseSet::kDefault,
           .suite = "stability",
           .run = run_stays},
          {.name = "gauntlet/cliff/falls",
           .title = "a box whose centre lies 5 mm beyond an edge falls",
           .set = CaseSet::kQuick,
           .suite = "stability",
           .run = run_falls}};
}

}  // namespace stiction
