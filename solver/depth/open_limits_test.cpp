// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/open_limits.h"

#include <gtest/gtest.h>

#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

Scene two_cubes(double swing_time) {
  SceneDescription description = test::stacked_cubes(1e-3);
  description.gravity = {{0.0}, {Eigen::Vector3d(0, 0, -10)}};
  Scene scene = build_scene(description);
  scene.swing_time = swing_time;
  return scene;
}

// Of cubes that swing in 1 ms, on which 10 m/s² act, m.
double gap(double hysteresis, double time_step, double swing_time = 1e-3) {
  const Scene scene = two_cubes(swing_time);
  Options options;
  options.time_step = time_step;
  options.pairs.hysteresis = static_cast<Real>(hysteresis);
  const OpenLimits limits(scene, options, initial_state(scene));
  EXPECT_GT(limits.border, 0.0);
  return static_cast<double>(limits.gap);
}

// Round-off of a few products, relative.
constexpr double kNear = by_precision(1e-12, 1e-5);

TEST(OpenLimits, AGapIsWhatABodySwingsWithTheSpeedOfOneStepOfGravity) {
  for (const double dt : {1e-5, 2e-5, 4e-5}) {
    EXPECT_NEAR(gap(1.0, dt) / (10.0 * dt * 1e-3), 1.0, kNear);
    EXPECT_NEAR(gap(0.5, dt) / (10.0 * dt * 1e-3), 0.5, kNear);
  }
}

TEST(OpenLimits, OfAStiffBodyAGapIsThatOfTwentySteps) {
  EXPECT_NEAR(gap(1.0, 1e-4) / (10.0 * 1e-4 * 2e-3), 1.0, kNear);
  EXPECT_NEAR(gap(1.0, 1e-4, 0.0) / (10.0 * 1e-4 * 2e-3), 1.0, kNear);
}

TEST(OpenLimits, WhatStandsAHundredthOfAnEdgeApartIsNotKept) {
  const auto edge = static_cast<double>(two_cubes(0.0).topology.mean_edge);
  EXPECT_NEAR(gap(1.0, 1e-4, 1e6) / edge, 1e-2, kNear);
  EXPECT_NEAR(gap(1.0, 1e-4, test::kInfinity) / edge, 1e-2, kNear);
}

TEST(OpenLimits, WithoutHysteresisNothingIsKept) {
  EXPECT_EQ(gap(0.0, 1e-4), 0.0);
  EXPECT_EQ(gap(0.0, 1e-4, test::kInfinity), 0.0) << "a time too long for a number";
}

}  // namespace
}  // namespace stiction
