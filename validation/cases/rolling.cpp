// SPDX-License-Identifier: GPL-3.0-or-later
// The rolling test with which SimBenchmark compares engines: a plate of 10 kg is dragged over the
// ground, 25 balls of 1 kg roll on it. Its table has for each engine the error of the velocities.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "validation/core/case_run.h"
#include "validation/problems/slopes/incline_problem.h"
#include "validation/protocols/incline_run.h"

namespace stiction {

namespace {

constexpr double kForce = 150.0;        // N
constexpr double kGround = 0.4;         // μ of the plate on the ground
constexpr double kBetween = 0.8;        // μ of the balls on the plate
constexpr double kPlate = 10.0;         // kg
constexpr double kBall = 1.0;           // kg
constexpr double kRollingRadius = 0.5;  // m
constexpr int kSide = 5;                // balls along a side
constexpr double kRollingTime = 2.0;    // s

// F − μ g (M + n m) = M a + n m a_b, with balls that roll on the plate: friction gives a ball a_b,
// and r α = ⁵⁄₂ a_b; rolling, a_b + r α = a. So a_b = ²⁄₇ a, far from what μ = 0.8 can hold.
constexpr double kBalls = kSide * kSide * kBall;
constexpr double kPlateAcceleration =
    (kForce - kGround * kStandardGravity * (kPlate + kBalls)) / (kPlate + 2.0 / 7.0 * kBalls);

Problem plate_and_balls(double azimuth) {
  Problem problem;
  problem.name = "balls on a plate";
  ProblemBody plate;
  plate.name = "plate";
  plate.shape = BoxShape{{20.0, 20.0, 1.0}};
  plate.mass = kPlate;
  plate.position = Vec3(0.0, 0.0, 0.5);
  problem.bodies = {plate};
  for (int k = 0; k < kSide * kSide; ++k) {
    ProblemBody ball;
    ball.name = fmt::format("ball {}", k);
    ball.shape = BallShape{kRollingRadius};
    ball.mass = kBall;
    ball.position = Vec3(2.0 * (k % kSide) - 4.0, 2.0 * (k / kSide) - 4.0, 1.0 + kRollingRadius);
    problem.bodies.push_back(ball);
  }
  problem.obstacles = {{"ground", Vec3::Zero(), Vec3::UnitZ(), kGround}};
  problem.friction = kBetween;
  problem.gravity = {{0.0}, {Vec3(0.0, 0.0, -kStandardGravity)}};
  problem.loads = {
      {.body = 0, .force = {{0.0}, {kForce * Vec3(std::cos(azimuth), std::sin(azimuth), 0.0)}}}};
  problem.duration = kRollingTime;
  return problem;
}

void run_rolling(CaseRun& run, double azimuth) {
  run.need(&Manifest::spin, "bodies that turn");
  const CaseRun::Running simulation = run.simulate(plate_and_balls(azimuth));
  simulation->record_frames(0.05);
  simulation->advance_to(kRollingTime);
  const Vec3 ahead(std::cos(azimuth), std::sin(azimuth), 0.0);
  const double seconds = simulation->time();
  const double plate = simulation->engine().body(0).velocity.dot(ahead) / seconds;
  double balls = 0.0, beside = 0.0;
  for (std::size_t b = 1; b <= kSide * kSide; ++b) {
    const Vec3 velocity = simulation->engine().body(b).velocity;
    balls += velocity.dot(ahead) / seconds / (kSide * kSide);
    beside = std::max(beside, (velocity - velocity.dot(ahead) * ahead).norm());
  }
  const double step = simulation->engine().time_step() / seconds;
  const std::string reason =
      "a step at the start, in which contacts are found; all forces are constant, so that a "
      "consistent integrator has no truncation error in velocities";
  run.check({.quantity = "acceleration of the plate",
             .unit = "m/s²",
             .statement = "a plate that is dragged over the ground carries balls that roll on it",
             .formula = "a = (F − μ g (M + n m))/(M + ²⁄₇ n m)",
             .source = "balance of momenta, Coulomb's law; 0.7385 in SimBenchmark",
             .kind = ReferenceKind::kAnalytic,
             .expected = kPlateAcceleration,
             .relative = true,
             .tolerance = 2.0 * step,
             .reason = reason},
            plate);
  run.check({.quantity = "mean acceleration of the balls",
             .unit = "m/s²",
             .statement = "… with two sevenths of its acceleration",
             .formula = "a_b = ²⁄₇ a",
             .source = "balance of momenta; 0.211 in SimBenchmark",
             .kind = ReferenceKind::kAnalytic,
             .expected = 2.0 / 7.0 * kPlateAcceleration,
             .relative = true,
             .tolerance = 2.0 * step,
             .reason = reason},
            balls);
  run.note(fmt::format("fastest ball across the force: {:.2e} m/s", beside));
}

Case rolling(int degrees) {
  return {.name = fmt::format("rolling/azimuth={}", degrees),
          .title = fmt::format("a plate dragged to {}° under 25 rolling balls", degrees),
          .set = CaseSet::kFull,
          .run = [=](CaseRun& run) { run_rolling(run, radians(degrees)); }};
}

}  // namespace

// Its 'diagonal' is (1, √3)/2.
std::vector<Case> cases_rolling() { return {rolling(0), rolling(60), rolling(90)}; }

}  // namespace stiction
