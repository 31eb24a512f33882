// SPDX-License-Identifier: BSD-3-Clause
#include "solver/observables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

// Two bodies: 2 kg at (1, 0, 0) and (3, 0, 0); 5 kg at (0, 1, 0), pinned … none.
Scene two_bodies() {
  Eigen::Matrix3Xd pair = Eigen::Matrix3Xd::Zero(3, 2);
  pair.row(0) << 1.0, 3.0;
  SceneDescription description = test::one_body(test::point_masses(pair, 2.0));
  description.bodies[0].initial_velocity = Eigen::Matrix3Xd::Zero(3, 2);
  description.bodies[0].initial_velocity.row(1) << 1.0, -2.0;
  description.bodies.push_back(test::point_masses(Vec3(0, 1, 0), 5.0));
  description.bodies[1].initial_velocity = Vec3(0, 0, 3);
  description.gravity = {{0.0, 2.0}, {Vec3::Zero(), Vec3(0, -10, 0)}};
  return build_scene(description);
}

// Whole numbers throughout, so nothing is rounded.
TEST(Observables, OfPointMassesAreWhatOneComputesByHand) {
  const Scene scene = two_bodies();
  const State state = initial_state(scene);
  EXPECT_EQ(kinetic_energy(scene, state), 0.5 * 2 * 1 + 0.5 * 2 * 4 + 0.5 * 5 * 9);
  EXPECT_EQ(linear_momentum(scene, state), Vec3(0, 2 - 4, 15));
  // (1,0,0) × (0,2,0) + (3,0,0) × (0,−4,0) + (0,1,0) × (0,0,15)
  EXPECT_EQ(angular_momentum(scene, state), Vec3(15, 0, 2 - 12));
}

TEST(Observables, UseGravityAtTheGivenTime) {
  const Scene scene = two_bodies();
  const State state = initial_state(scene);
  EXPECT_EQ(gravity_energy(scene, state, 0.0), 0.0);
  EXPECT_EQ(gravity_energy(scene, state, 1.0), 25.0);  // half of it: 5 kg · 5 m/s² · 1 m
  EXPECT_EQ(gravity_energy(scene, state, 2.0), 50.0);
}

TEST(Observables, SeeEachBodyAlone) {
  const Scene scene = two_bodies();
  const State state = initial_state(scene);
  EXPECT_EQ(centre_of_mass(scene, state, scene.bodies[0]), Vec3(2, 0, 0));
  EXPECT_EQ(centre_of_mass(scene, state, scene.bodies[1]), Vec3(0, 1, 0));
  EXPECT_EQ(centre_velocity(scene, state, scene.bodies[0]), Vec3(0, -0.5, 0));
  EXPECT_EQ(centre_velocity(scene, state, scene.bodies[1]), Vec3(0, 0, 3));
}

TEST(Observables, WeighVerticesByTheirMass) {
  // A corner tetrahedron and the point mass that its body carries beside it.
  BodyDescription body = test::elastic_body(test::corner_tetrahedron());
  body.mesh.vertices.conservativeResize(3, 5);
  body.mesh.vertices.col(4) = Vec3(10, 0, 0);
  body.point_mass = 500.0 / 6.0;  // half the tetrahedron's
  const Scene scene = build_scene(test::one_body(body));
  const Vec3 expected = (Vec3::Constant(0.25) + 0.5 * Vec3(10, 0, 0)) / 1.5;
  // Round-off of five terms of up to 5.
  EXPECT_LT((centre_of_mass(scene, initial_state(scene), scene.bodies[0]) - expected).norm(),
            25 * test::kEpsilon);
}

// Two masses on the z axis, which have no inertia about it.
TEST(Observables, TurnNothingAboutAnAxisWithoutInertia) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 2);
  points.row(2) << -1.0, 1.0;
  const Scene scene = build_scene(test::one_body(test::point_masses(points, 1.0)));
  const State state = initial_state(scene);
  const double inertia_about_x = scene.mass[0] + scene.mass[1];  // Σ m · (1 m)²
  const Eigen::Vector3d turned = over_inertia(scene, state, scene.bodies[0], {3.0, -5.0, 7.0});
  EXPECT_LT((inertia_about_x * turned - Eigen::Vector3d(3.0, -5.0, 0.0)).norm(), 1e-14);
  State at_one_point = state;
  for (Position& position : at_one_point.position) position.x.setZero();
  EXPECT_EQ(over_inertia(scene, at_one_point, scene.bodies[0], {1.0, 1.0, 1.0}),
            Eigen::Vector3d(0.0, 0.0, 0.0));
}

TEST(IsFinite, SeesASingleNaNInPositionsOrVelocitiesAndNotThePadding) {
  const Scene scene = two_bodies();
  State state = initial_state(scene);
  state.position[1].unused = test::kNaN;
  EXPECT_TRUE(is_finite(state));
  state.position[1].x.y() = test::kNaN;
  EXPECT_FALSE(is_finite(state));
  state = initial_state(scene);
  state.velocity[2].v.z() = test::kInfinity;
  EXPECT_FALSE(is_finite(state));
}

TEST(IsFinite, RefusesNumbersWhoseEnergyIsNone) {
  const Scene scene = two_bodies();
  State state = initial_state(scene);
  state.velocity[2].v.z() = -std::sqrt(std::numeric_limits<Real>::max());
  EXPECT_FALSE(is_finite(state));
  state = initial_state(scene);
  state.position[0].x.x() = std::sqrt(std::numeric_limits<Real>::max());
  EXPECT_FALSE(is_finite(state));
}

}  // namespace
}  // namespace stiction
