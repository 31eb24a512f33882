// SPDX-License-Identifier: GPL-3.0-or-later
// A semicircular arch of dry voussoirs stands if it is thick enough, and else falls by hinges.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "validation/core/case_run.h"
#include "validation/problems/piles/arch_problem.h"

namespace stiction {

namespace {

constexpr double kGone = 0.05;  // of R: so far the crown of an arch that falls comes down, at least

// How far any block has moved, m, at the end; stops early once one has fallen.
struct Moved {
  double way = 0.0;
  std::string block{};
  double late = 0.0;  // in the last quarter, m
};

Moved moved_in(CaseRun& run, const ArchSetup& setup, double duration, const Accuracy& accuracy) {
  const Problem problem = arch_problem(setup);
  const auto simulation = run.simulate(problem, accuracy);
  simulation->record_frames(0.02);
  const Engine& engine = simulation->engine();
  Series series{"farthest voussoir", "m", "time", "s", {}, {}};
  std::vector<Vec3> late;
  Moved moved;
  constexpr int kSamples = 100;
  for (int k = 1; k <= kSamples && moved.way < 2.0 * kGone * setup.radius; ++k) {
    simulation->advance_to(duration * k / kSamples);
    moved.way = 0.0;
    for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
      const double way = (engine.body(b).position - problem.bodies[b].position).norm();
      if (way > moved.way) moved = {way, problem.bodies[b].name, 0.0};
      if (4 * k == 3 * kSamples) late.push_back(engine.body(b).position);
    }
    series.x.push_back(simulation->time());
    series.y.push_back(moved.way);
  }
  for (std::size_t b = 0; b < late.size(); ++b) {
    moved.late = std::max(moved.late, (engine.body(b).position - late[b]).norm());
  }
  run.add(series);
  return moved;
}

void run_arch(CaseRun& run, ArchSetup setup, double share, double duration,
              const Accuracy& accuracy) {
  const double least = least_thickness(setup);
  setup.thickness = share * least;
  run.note(fmt::format("t/R = {:.6f}, {:g} times the least of {} blocks, {:.6f} (limit analysis)",
                       setup.thickness / setup.radius, share, setup.blocks, least / setup.radius));
  const bool stands = share > 1.0;
  // Blocks that rock in their joints are damped little by their strain; one that falls is free.
  if (stands) setup.drag_ends = 0.4 * duration;
  const Moved moved = moved_in(run, setup, duration, accuracy);
  run.check(
      {.quantity = "farthest way of a voussoir",
       .unit = "m",
       .statement = stands ? "an arch thicker than the least stands"
                           : "an arch thinner than the least falls by hinges",
       .formula = stands ? "x(end) = x(0)" : "x(end) − x(0) > R/20",
       .source = "limit analysis of rigid blocks that touch at the corners of their joints",
       .kind = ReferenceKind::kExactComputed,
       .expected = stands ? 0.0 : 2.0 * kGone * setup.radius,
       .tolerance = stands ? 0.05 * setup.thickness : kGone * setup.radius,
       .reason = stands ? "half of the tenth by which it is thicker: joints that open by more "
                          "take the line of thrust out of it; elastic blocks give by 1e-4 R"
                        : "R/20 or more: a question of yes or no. The run ends at R/10"},
      stands ? moved.way : std::min(moved.way, 3.0 * kGone * setup.radius), moved.block);
  if (!stands) return;
  run.check({.quantity = "creep",
             .unit = "m/s",
             .statement = "… and does not move on: mean speed in the last quarter",
             .formula = "v = 0",
             .source = "static equilibrium",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 1e-9,
             .reason = "the paper's 1e-9 m/s of static contacts"},
            moved.late / (0.25 * duration), moved.block);
}

}  // namespace

std::vector<Case> cases_arch() {
  std::vector<Case> cases;
  const auto add = [&](const std::string& name, const std::string& title, CaseSet set, double share,
                       double duration, double finer) {
    cases.push_back({.name = name, .title = title, .set = set, .run = [=](CaseRun& run) {
                       run_arch(run, {}, share, duration, {.finer = finer});
                     }});
  };
  add("arch/stands/110%", "an arch 1.1 times as thick as it must be stands", CaseSet::kDefault, 1.1,
      3.0, 1.0);
  add("arch/stands/110%/doubled", "… in twice the time, with half the step", CaseSet::kFull, 1.1,
      6.0, 2.0);
  add("arch/falls/90%", "an arch 0.9 times as thick as it must be falls", CaseSet::kDefault, 0.9,
      2.0, 1.0);
  return cases;
}

}  // namespace stiction
