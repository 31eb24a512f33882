// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <string>

#include "validation/protocols/incline_run.h"

namespace stiction {

namespace {

constexpr double kBallRadius = 0.1;                 // m
constexpr double kRollsFrom = 0.1, kRollsTo = 0.5;  // s

// Friction f on a solid ball turns it, f r = ⅖ m r² α: it rolls while f = ²⁄₇ m g sin θ ≤ μ m g cos θ,
// with a = ⁵⁄₇ g sin θ and α r = a. Beyond, tan θ > ⁷⁄₂ μ, it slides: a = g(sin θ − μ cos θ),
// α r = ⁵⁄₂ μ g cos θ.
struct Rolling {
  double acceleration;  // m/s²
  double spin;          // α, rad/s²
};

Rolling rolling(double angle, double friction) {
  const double down = kStandardGravity * std::sin(angle);
  if (std::tan(angle) <= 3.5 * friction) return {5.0 / 7.0 * down, 5.0 / 7.0 * down / kBallRadius};
  const double rub = friction * kStandardGravity * std::cos(angle);
  return {down - rub, 2.5 * rub / kBallRadius};
}

void run_ball(CaseRun& run, double friction) {
  run.need(&Manifest::spin, "bodies that turn");
  InclineSetup setup;
  setup.friction = friction;
  setup.tan_slope = std::tan(radians(20.0));
  setup.azimuth = radians(30.0);
  Problem problem = incline_problem(setup);
  const InclineFrame frame = incline_frame(setup);
  ProblemBody& ball = problem.bodies[0];
  ball.name = "ball";
  ball.shape = BallShape{kBallRadius};
  ball.position = kBallRadius * frame.normal;
  // Facets are small: strain-rate damping as of a box would ask for steps of 2 µs.
  ball.elasticity.damping_time = 1e-5;
  const CaseRun::Running simulation = run.simulate(problem);
  simulation->record_frames(0.02);
  const Vec3 axis = frame.normal.cross(frame.downhill);
  simulation->advance_to(kRollsFrom);
  const double from = simulation->time();
  const BodyMotion before = simulation->engine().body(0);
  simulation->advance_to(kRollsTo);
  const double seconds = simulation->time() - from;
  const BodyMotion after = simulation->engine().body(0);
  const Rolling expected = rolling(radians(20.0), friction);
  const double steps = seconds / simulation->engine().time_step();
  const double round_off = 8.0 * steps * std::numeric_limits<double>::epsilon();
  const std::string reason =
      "round-off: some eight roundings a step; under constant forces a consistent integrator has "
      "no truncation error in velocities";
  run.check({.quantity = "acceleration",
             .unit = "m/s²",
             .statement = "a solid ball rolls while its contact can hold it, and slides beyond",
             .formula = "a = ⁵⁄₇ g sin θ if tan θ ≤ ⁷⁄₂ μ, else g(sin θ − μ cos θ)",
             .source = "balance of momenta, Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = expected.acceleration,
             .relative = true,
             .tolerance = round_off,
             .reason = reason,
             .headline = "acceleration of a ball on a slope"},
            (after.velocity - before.velocity).dot(frame.downhill) / seconds);
  run.check({.quantity = "angular acceleration",
             .unit = "rad/s²",
             .statement = "… and turns as friction makes it",
             .formula = "α = a/r while it rolls, else ⁵⁄₂ μ g cos θ/r",
             .source = "balance of angular momentum, Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = expected.spin,
             .relative = true,
             .tolerance = round_off,
             .reason = reason},
            (after.angular_velocity - before.angular_velocity).dot(axis) / seconds);
}

}  // namespace

std::vector<Case> cases_slope_ball() {
  return {{.name = "slope/ball/rolls",
           .title = "a solid ball rolls down 20° at μ = 0.5",
           .run = [](CaseRun& run) { run_ball(run, 0.5); }},
          {.name = "slope/ball/slides",
           .title = "a solid ball slides and turns down 20° at μ = 0.05",
           .run = [](CaseRun& run) { run_ball(run, 0.05); }}};
}

}  // namespace stiction
