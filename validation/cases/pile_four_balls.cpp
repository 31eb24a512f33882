// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "reference/limit/limit_scenes.h"
#include "validation/core/case_run.h"
#include "validation/estimate/threshold.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

constexpr double kRadius = 0.1;  // of the three lower balls, m
constexpr double kRatio = 1.75;  // of the top ball's to theirs: gives the paper's two thresholds
constexpr double kDensity = 1000.0;  // kg/m³
constexpr double kLoaded = 0.3;      // gravity has grown to full, s
constexpr double kWatched = 3.0;     // until then, s
constexpr double kSunk = 1e-2;       // of the radius: by then it breaks

ProblemBody ball(const std::string& name, double radius, const Vec3& position) {
  ProblemBody body;
  body.name = name;
  body.shape = BallShape{radius};
  body.mass = kDensity * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  body.elasticity = {.youngs_modulus = 1e6, .poisson_ratio = 0.3, .damping_time = 1e-5};
  body.position = position;
  return body;
}

// The paper's Fig. 7 of smooth balls: three that just touch each other, a larger one in the hollow
// between them, no medium.
Problem four_balls(double friction) {
  const double spread = 2.0 * kRadius / std::numbers::sqrt3;  // from the axis
  const double apart = (1.0 + kRatio) * kRadius;              // top's centre to a lower one's
  Problem problem;
  problem.name = "four smooth balls";
  for (int k = 0; k < 3; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 3.0;
    problem.bodies.push_back(ball(fmt::format("lower {}", k), kRadius,
                                  {spread * std::cos(angle), spread * std::sin(angle), kRadius}));
  }
  problem.bodies.push_back(ball("top", kRatio * kRadius,
                                {0.0, 0.0, kRadius + std::sqrt(apart * apart - spread * spread)}));
  problem.obstacles = {{"ground", Vec3::Zero(), Vec3::UnitZ(), friction}};
  problem.friction = friction;
  problem.gravity = {{0.0, kLoaded}, {Vec3::Zero(), Vec3(0.0, 0.0, -kStandardGravity)}};
  problem.duration = kWatched;
  return problem;
}

// How far the top ball sinks while it is watched, m; it is left when it has fallen.
double sinks(CaseRun& run, double friction) {
  const CaseRun::Running simulation = run.simulate(four_balls(friction));
  simulation->record_frames(0.02);
  simulation->advance_to(1.2 * kLoaded);  // the weight has pressed soft balls together
  const double from = simulation->engine().body(3).position.z();
  double sunk = 0.0;
  for (int k = 1; k <= 20 && sunk < 0.5 * kRadius; ++k) {
    simulation->advance_to(1.2 * kLoaded + (kWatched - 1.2 * kLoaded) * k / 20.0);
    sunk = from - simulation->engine().body(3).position.z();
    if (std::isnan(sunk)) break;
  }
  return sunk;
}

Holding stands(CaseRun& run, double friction) {
  run.bodies_are_thrown();
  const double excess = sinks(run, friction) - kSunk * kRadius;
  return {excess < 0.0, excess};
}

void run_threshold(CaseRun& run) {
  constexpr double kWidth = 2e-4;
  const double expected = reference::four_ball_thresholds(kRatio).ball;
  const auto holds = [&](double friction) { return stands(run, friction); };
  Bracket bracket = find_threshold_near(expected + 0.4 * kWidth, -kWidth, 0.2, kWidth, holds);
  if (std::isnan(bracket.holds)) bracket = find_threshold(1.5, 0.01, kWidth, holds);
  const double time = kWatched - 1.2 * kLoaded;
  const double slow = 2.0 * kSunk * kRadius / (kStandardGravity * time * time);
  run.check({.quantity = "critical μ",
             .unit = "1",
             .statement = "the least friction with which four smooth balls stand",
             .formula = "μ = tan(θ/2), sin θ = (2/√3)/(1 + R/r)",
             .source = "[Lazarevych2009], sec. 5: ≈ 0.22; derived (reference/limit/limit_scenes.h)",
             .kind = ReferenceKind::kAnalytic,
             .expected = expected,
             .tolerance = 0.5 * kWidth + slow,
             .reason = fmt::format("half the bracket; and short of it by δ the pile sinks with an "
                                   "acceleration of about g δ, which takes δ = {:.1g} to 1 % of a "
                                   "radius in {:.2g} s",
                                   slow, time)},
            bracket.middle(),
            fmt::format("stands at {:.5f}, breaks at {:.5f}; {} runs", bracket.holds, bracket.fails,
                        bracket.evaluations));
}

void run_stands(CaseRun& run) {
  const double sunk = sinks(run, 0.24);
  run.check({.quantity = "top ball's sinking at μ = 0.24",
             .unit = "m",
             .statement = "above its critical friction the pyramid stands",
             .formula = "0",
             .source = "[Lazarevych2009], sec. 5; static equilibrium",
             .kind = ReferenceKind::kExternal,
             .expected = 0.0,
             .tolerance = kSunk * kRadius,
             .reason = "what breaks sinks by more than 1 % of a radius; soft balls have been "
                       "pressed together before"},
            sunk);
}

void run_breaks(CaseRun& run) {
  run.bodies_are_thrown();
  const double sunk = sinks(run, 0.20);
  run.check({.quantity = "breaks at μ = 0.20",
             .unit = "1",
             .statement = "below its critical friction it breaks: the top ball sinks",
             .source = "[Lazarevych2009], sec. 5",
             .kind = ReferenceKind::kExternal,
             .expected = 1.0,
             .tolerance = 0.0,
             .reason = "yes or no: whether it has sunk by 1 % of a radius"},
            sunk > kSunk * kRadius ? 1.0 : 0.0, fmt::format("it sank {:.3g} mm", 1e3 * sunk));
}

}  // namespace

std::vector<Case> cases_pile_four_balls() {
  return {{.name = "pile/four-balls/threshold",
           .title = "the least friction of a pyramid of four smooth balls",
           .set = CaseSet::kFull,
           .run = run_threshold},
          {.name = "pile/four-balls/mu=0.24",
           .title = "a pyramid of four smooth balls stands at μ = 0.24",
           .set = CaseSet::kFull,
           .run = run_stands},
          {.name = "pile/four-balls/mu=0.2",
           .title = "a pyramid of four smooth balls breaks at μ = 0.20",
           .set = CaseSet::kFull,
           .run = run_breaks}};
}

}  // namespace stiction
