// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/detect.h"

#include <gtest/gtest.h>

#include "solver/detection/boxes.h"
#include "solver/detection/detect_pairs.h"
#include "solver/testing/test_pairs.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

// Three points along x, 1 m above the ground, between which and a wall at x = 1.5 they may fall.
Scene three_points() {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 3);
  points.row(0) << 0.0, 1.0, 2.0;
  SceneDescription description = test::one_body(test::point_masses(points, 1.0));
  return build_scene(description);
}

TEST(Detect, FindsVerticesWhosePredictedPositionIsInside) {
  Scene scene = three_points();
  scene.half_spaces = {test::ground(test::kNaN)};  // μ is none of its business
  State state = initial_state(scene);
  state.position[0].x.z() = 0.5;  // falls to 0.5 − 0.25 · 1
  state.velocity[0].v.z() = -1.0;
  state.position[1].x.z() = 0.5;  // falls to 0.5 − 0.25 · 4
  state.velocity[1].v.z() = -4.0;
  state.position[2].x.z() = -0.5;  // rises to −0.5 + 0.25 · 4
  state.velocity[2].v.z() = 4.0;
  OneSidedContacts contacts;
  detect(scene, 0.25, state.position, state.velocity, contacts);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts.vertex[0], 1);
  EXPECT_EQ(contacts.obstacle[0], 0);
  EXPECT_EQ(contacts.key[0], contact_key(0, 1));
  EXPECT_EQ(contacts.depth[0], 0.5);
}

TEST(Detect, DoesNotCountAVertexOnThePlane) {
  Scene scene = three_points();
  scene.half_spaces = {test::ground(0.0)};
  const State state = initial_state(scene);  // all at z = 0
  OneSidedContacts contacts;
  detect(scene, 0.25, state.position, state.velocity, contacts);
  EXPECT_EQ(contacts.size(), 0u);
}

TEST(Detect, GivesContactsByObstacleThenVertexAndForgetsOldOnes) {
  Scene scene = three_points();
  scene.half_spaces = {test::ground(0.0), {"wall", Vec3(1.5, 0, 0), Vec3::UnitX(), 0.0}};
  State state = initial_state(scene);
  for (Position& position : state.position) position.x.z() = -0.125;
  OneSidedContacts contacts;
  contacts.add(contact_key(9, 9), 9, 9, 9.0);
  detect(scene, 0.25, state.position, state.velocity, contacts);
  EXPECT_EQ(contacts.vertex, (std::vector<std::int32_t>{0, 1, 2, 0, 1}));
  EXPECT_EQ(contacts.obstacle, (std::vector<std::int32_t>{0, 0, 0, 1, 1}));
  EXPECT_EQ(contacts.depth, (std::vector<double>{0.125, 0.125, 0.125, 1.5, 0.5}));
  for (std::size_t c = 0; c + 1 < contacts.size(); ++c) {
    EXPECT_LT(contacts.key[c], contacts.key[c + 1]);
  }
  EXPECT_EQ(contacts.normal_force.size(), contacts.size());
  EXPECT_EQ(contacts.friction_force.size(), contacts.size());
}

TEST(Detect, MeasuresDepthAlongATiltedNormalFromAnyPointOfThePlane) {
  Scene scene = three_points();
  const Vec3 normal(0.6, 0.0, 0.8);
  scene.half_spaces = {{"slope", Vec3(0.8, 5.0, -0.6), normal, 0.0}};  // through the origin
  State state = initial_state(scene);
  for (Position& position : state.position) position.x = -3.0 * normal;
  OneSidedContacts contacts;
  detect(scene, 0.25, state.position, state.velocity, contacts);
  ASSERT_EQ(contacts.size(), 3u);
  // Round-off of products of up to 3.
  for (const double depth : contacts.depth) EXPECT_NEAR(depth, 3.0, 6 * test::kEpsilon);
}

TEST(Detect, TestsOnlySurfaceVerticesThatCanMove) {
  BodyDescription body = test::elastic_body(test::cube_mesh(2));
  body.pinned = {0, 1, 2};
  Scene scene = build_scene(test::one_body(body));
  scene.half_spaces = {{"everywhere", Vec3(0, 0, 10), Vec3::UnitZ(), 0.0}};
  const State state = initial_state(scene);
  OneSidedContacts contacts;
  detect(scene, 1e-3, state.position, state.velocity, contacts);
  EXPECT_EQ(contacts.size(), 27u - 1u - 3u);  // all but the one inside and the pinned ones
  for (const std::int32_t v : contacts.vertex) {
    EXPECT_NE(state.velocity[static_cast<std::size_t>(v)].inverse_mass, 0.0);
    EXPECT_NE(state.position[static_cast<std::size_t>(v)].x, Vec3::Constant(0.5));
  }
}

// Two cubes on each other fall past a slope and a wall, turned and trembling.
TEST(Detect, PassesOverBodiesThatAreClearAndMissesNoneThatComes) {
  SceneDescription description = test::stacked_cubes(-0.01);
  description.half_spaces = {{"slope", Vec3(0, 0, -0.3), Vec3(0.6, 0.0, 0.8), 0.0},
                             {"wall", Vec3(0, 1.3, 0), -Vec3::UnitY(), 0.0}};
  const Scene scene = build_scene(description);
  Workspace workspace;
  std::size_t none = 0, some = 0;
  for (unsigned k = 0; k < 400; ++k) {
    Eigen::Matrix3Xd position =
        scene.rest_position.cast<double>() + test::noise(scene.vertex_count(), 1e-4, k);
    position.colwise() += Eigen::Vector3d(0.0, 1e-3 * k, -2e-3 * k);
    const State state =
        test::state_at(scene, position, Eigen::Matrix3Xd::Zero(3, scene.vertex_count()));
    workspace.velocity = state.velocity;
    detect_pairs(scene, {.time_step = 1e-3}, state, workspace);
    OneSidedContacts all, passing_over;
    detect(scene, 1e-3, state.position, state.velocity, all);
    detect(scene, 1e-3, state.position, state.velocity, passing_over, 0.0, &workspace.search);
    ASSERT_EQ(passing_over.key, all.key) << k;
    ASSERT_EQ(passing_over.depth, all.depth) << k;
    none += all.size() == 0;
    some += all.size() > 0;
  }
  EXPECT_GT(none, 20u);
  EXPECT_GT(some, 20u);
}

TEST(Boxes, AreClearOfAHalfSpaceWhereTheirNearestCornerIs) {
  const Box3 box(Vec3(1, 2, 3), Vec3(2, 4, 6));
  const Vec3 normal = Vec3(-2, 0, 1).normalized();  // the nearest corner: 2, any, 3
  EXPECT_TRUE(clear_of(box, normal, Vec3(2, 9, 2.99)));
  EXPECT_FALSE(clear_of(box, normal, Vec3(2, 9, 3.01)));
  EXPECT_FALSE(clear_of(box, normal, Vec3::Constant(test::kNaN)));
}

}  // namespace
}  // namespace stiction
