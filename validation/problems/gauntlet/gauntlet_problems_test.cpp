// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <vector>

#include "reference/exact/overlap.h"
#include "solver/mesh/mesh.h"
#include "validation/problems/gauntlet/balance_problem.h"
#include "validation/problems/gauntlet/cliff_problem.h"
#include "validation/problems/gauntlet/slider_problem.h"
#include "validation/problems/gauntlet/spike_bed_problem.h"
#include "validation/problems/gauntlet/tip_collision_problem.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {
namespace {

reference::Skin skin_of(const ProblemBody& body) {
  const TetMesh& mesh = std::get<MeshShape>(body.shape).mesh;
  return {surface_triangles(mesh.tetrahedra),
          (body.rotation.toRotationMatrix() * mesh.vertices).colwise() + body.position};
}

// Nothing lies in anything else when it starts, but for the roundings of its coordinates.
void expect_apart(const Problem& problem) {
  constexpr double kRoundOff = 1e-15;  // m, of 0.1 m
  for (std::size_t a = 0; a < problem.bodies.size(); ++a) {
    for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
      if (a == b) continue;
      EXPECT_FALSE(
          reference::deepest(skin_of(problem.bodies[a]), skin_of(problem.bodies[b]), kRoundOff))
          << problem.name << ": " << problem.bodies[a].name << " in " << problem.bodies[b].name;
    }
  }
}

TEST(GauntletProblems, StartApart) {
  for (const Foot foot : {Foot::kNone, Foot::kSpike, Foot::kRidge}) {
    for (const Perch perch : {Perch::kFlat, Perch::kSpike, Perch::kRidge, Perch::kValley}) {
      if (foot != Foot::kSpike && perch == Perch::kValley) continue;  // too broad for it
      expect_apart(balance_problem({.foot = foot, .perch = perch}));
    }
  }
  expect_apart(balance_problem({.perch = Perch::kSpike, .offset = {2e-3, 1e-3}, .foot_yaw = 20.0}));
  expect_apart(balance_problem({.perch = Perch::kValley, .foot_yaw = 10.0, .perch_yaw = 40.0}));
  expect_apart(cliff_problem({.yaw = 30.0}));
  expect_apart(spike_bed_problem({}));
  expect_apart(
      spike_bed_problem({.spikes = true, .shift = {0.5 * kBedPad, 0.0}, .drop = -kBedHeight}));
  expect_apart(spike_bed_problem(
      {.spikes = true, .height = 0.015, .shift = {0.5 * kBedPad, 0.0}, .drop = -0.015}));
  for (const bool ridges : {false, true}) expect_apart(tip_collision_problem({.ridges = ridges}));
  for (const Slider slider : {Slider::kBox, Slider::kSpikes, Slider::kRidges}) {
    expect_apart(slider_problem({.slider = slider, .azimuth = 30.0, .irregular = true}));
  }
}

TEST(GauntletSlider, GoesWhereItsBrakingSays) {
  const SliderSetup setup;
  const double step = 1e-6;
  const double decelerated = (slid(setup, 0.2).speed - slid(setup, 0.2 + step).speed) / step;
  EXPECT_NEAR(decelerated, setup.friction * kStandardGravity, 1e-6);
  const double moved = (slid(setup, 0.2 + step).distance - slid(setup, 0.2).distance) / step;
  EXPECT_NEAR(moved, slid(setup, 0.2).speed, 1e-5);
  // The ramp, by summing it.
  const Gravity gravity = slider_problem(setup).gravity;
  double speed = setup.speed, distance = 0.0;
  const int count = 100000;
  for (int k = 0; k < count; ++k) {
    const double dt = setup.ramp / count;
    const double before = speed;
    speed += setup.friction * gravity.at((k + 0.5) * dt).z() * dt;
    distance += 0.5 * (before + speed) * dt;
  }
  EXPECT_NEAR(slid(setup, setup.ramp).speed, speed, 1e-9);
  EXPECT_NEAR(slid(setup, setup.ramp).distance, distance, 1e-10);
}

}  // namespace
}  // namespace stiction
