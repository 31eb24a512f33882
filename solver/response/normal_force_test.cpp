// SPDX-License-Identifier: BSD-3-Clause
#include "solver/response/normal_force.h"

#include <gtest/gtest.h>

#include "solver/detection/detect.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

constexpr double kDt = 0.25;  // s: a power of two, so that divisions round nothing

struct Pushed {
  State state;
  Workspace workspace;
  double gap(const HalfSpace& obstacle) const {  // at the end of the step
    return obstacle.normal.dot(state.position[0].x + kDt * state.velocity[0].v - obstacle.point);
  }
};

// One 2 kg point at `x` that moves with `v`, after detection and normal forces.
Pushed push(const std::vector<HalfSpace>& obstacles, const Vec3& x, const Vec3& v) {
  SceneDescription description = test::one_body(test::point_masses(Vec3::Zero(), 2.0));
  Scene scene = build_scene(description);
  scene.half_spaces = obstacles;
  Pushed pushed;
  pushed.state = test::state_at(scene, x, v);
  detect(scene, kDt, pushed.state.position, pushed.state.velocity, pushed.workspace.contacts);
  pushed.workspace.velocity = pushed.state.velocity;
  for (double& force : pushed.workspace.contacts.normal_force)
    force = test::kNaN;                                                      // to be overwritten
  for (double& depth : pushed.workspace.contacts.depth) depth = test::kNaN;  // found afresh
  normal_forces(scene, kDt, pushed.state, pushed.workspace);
  pushed.state.velocity = pushed.workspace.velocity;
  return pushed;
}

TEST(NormalForce, EndsTheStepOnThePlaneAndLeavesTheTangentAlone) {
  const Pushed pushed = push({test::ground(0.0)}, Vec3(0, 0, 0.5), Vec3(1, 2, -8));
  ASSERT_EQ(pushed.workspace.contacts.size(), 1u);
  EXPECT_EQ(pushed.state.velocity[0].v, Vec3(1, 2, -2));  // 0.5 m in 0.25 s
  EXPECT_EQ(pushed.gap(test::ground(0.0)), 0.0);
}

TEST(NormalForce, IsMassTimesDepthOverTheSquareOfTheStep) {
  const Pushed pushed = push({test::ground(0.0)}, Vec3(0, 0, 0.5), Vec3(0, 0, -8));
  EXPECT_EQ(pushed.workspace.contacts.normal_force[0], 2.0 * 1.5 / (kDt * kDt));
}

TEST(NormalForce, LosesTheEnergyOfTheApproachAndCreatesNone) {
  for (const double height : {0.0, 0.1, 0.5, 1.0}) {
    for (const double speed : {0.1, 1.0, 10.0}) {
      const Pushed pushed = push({test::ground(0.0)}, Vec3(0, 0, height), Vec3(3, 0, -speed));
      const double v = pushed.state.velocity[0].v.z();
      EXPECT_LE(v, 0.0) << "no rebound from " << height;
      EXPECT_GE(v, -speed) << "no pull from " << height;
      EXPECT_EQ(pushed.state.velocity[0].v.x(), 3.0);
    }
  }
}

TEST(NormalForce, DoesNotPullAContactThatAnotherOneHasOpened) {
  // The first plane throws the point over the second: what is left of its depth is negative.
  const HalfSpace steep{"steep", Vec3::Zero(), Vec3(0.6, 0.0, 0.8), 0.0};
  const HalfSpace flat{"flat", Vec3(0, 0, 0.01), Vec3::UnitZ(), 0.0};
  const Pushed pushed = push({steep, flat}, Vec3::Zero(), Vec3(-4, 0, 0));
  ASSERT_EQ(pushed.workspace.contacts.size(), 2u);
  EXPECT_GT(pushed.workspace.contacts.normal_force[0], 0.0);
  EXPECT_EQ(pushed.workspace.contacts.normal_force[1], 0.0);
  EXPECT_GT(pushed.gap(flat), 0.0);
}

TEST(NormalForce, OfTwoEqualPlanesPushesOnce) {
  const Pushed once = push({test::ground(0.0)}, Vec3(0, 0, 0.5), Vec3(0, 0, -8));
  const Pushed twice =
      push({test::ground(0.0), test::ground(0.0)}, Vec3(0, 0, 0.5), Vec3(0, 0, -8));
  ASSERT_EQ(twice.workspace.contacts.size(), 2u);
  EXPECT_EQ(twice.workspace.contacts.normal_force[0], once.workspace.contacts.normal_force[0]);
  EXPECT_EQ(twice.workspace.contacts.normal_force[1], 0.0);
  EXPECT_EQ(twice.state.velocity[0].v, once.state.velocity[0].v);
}

TEST(NormalForce, OfACornerPutsTheVertexOnBothPlanes) {
  const HalfSpace wall{"wall", Vec3::Zero(), Vec3::UnitX(), 0.0};
  const Pushed pushed = push({test::ground(0.0), wall}, Vec3(0.25, 0, 0.5), Vec3(-4, 1, -8));
  EXPECT_EQ(pushed.state.velocity[0].v, Vec3(-1, 1, -2));
}

}  // namespace
}  // namespace stiction
