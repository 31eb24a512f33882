// SPDX-License-Identifier: BSD-3-Clause
#include "solver/motion/predict.h"

#include <gtest/gtest.h>

#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

TEST(GravityForces, AreMassTimesGravityAtThatTime) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 2);
  points(0, 1) = 1.0;
  SceneDescription description = test::one_body(test::point_masses(points, 2.0));
  description.gravity = {{0.0, 2.0}, {Vec3::Zero(), Vec3(4, 0, -8)}};
  const Scene scene = build_scene(description);
  std::vector<Force> force(
      7, {Vec3::Constant(test::kNaN), test::kNaN});  // what it held does not matter
  gravity_forces(scene, 1.0, force);
  ASSERT_EQ(force.size(), 2u);
  for (const Force& each : force) EXPECT_EQ(each.f, Vec3(4, 0, -8));
}

TEST(DragForces, OpposeTheVelocityWhileTheyLast) {
  SceneDescription description =
      test::one_body(test::point_masses(Eigen::Matrix3Xd::Zero(3, 1), 2.0));
  description.drag = {.rate = 3.0, .full_until = 1.0, .ends = 2.0};
  const Scene scene = build_scene(description);
  const std::vector<Velocity> velocity = {{Vec3(1, 0, -2), 0.5}};
  std::vector<Force> force = {{Vec3(1, 1, 1)}};
  add_drag_forces(scene, 0.5, velocity, force);
  EXPECT_EQ(force[0].f, Vec3(-5, 1, 13));
  add_drag_forces(scene, 2.0, velocity, force);
  EXPECT_EQ(force[0].f, Vec3(-5, 1, 13));
}

TEST(Predict, AddsForceOverMassForOneStep) {
  const std::vector<Velocity> start = {{Vec3(1, 2, 3), 0.5}};
  std::vector<Velocity> predicted;
  predict(0.25, {{Vec3(8, 0, -16)}}, start, predicted);
  ASSERT_EQ(predicted.size(), 1u);
  EXPECT_EQ(predicted[0].v, Vec3(2, 2, 1));
  EXPECT_EQ(predicted[0].inverse_mass, 0.5);
}

TEST(Predict, MovesNoPinnedVertex) {
  const std::vector<Velocity> start = {{Vec3::Zero(), 0.0}};
  std::vector<Velocity> predicted = {{Vec3::Constant(test::kNaN), test::kNaN}};
  predict(0.25, {{Vec3(8, 0, -16)}}, start, predicted);
  EXPECT_EQ(predicted[0].v, Vec3::Zero());
}

}  // namespace
}  // namespace stiction
