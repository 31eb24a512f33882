// SPDX-License-Identifier: BSD-3-Clause
#include "solver/friction/friction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "solver/friction/catalog.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

constexpr double kDt = 0.25;   // s
constexpr double kMass = 2.0;  // kg
constexpr double kInverse = kDt / kMass;

Options with_rule(const std::string& rule) { return {.time_step = kDt, .rule = rule}; }

// Points in a row on the ground, of which some touch it in this step.
class FrictionPhase : public testing::TestWithParam<std::string> {
 protected:
  explicit FrictionPhase(double mu = 0.5) {
    Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 5);
    points.row(0) << 0, 1, 2, 3, 4;
    scene = build_scene(test::one_body(test::point_masses(points, kMass)));
    scene.half_spaces = {test::ground(mu)};
    state = initial_state(scene);
    for (Position& position : state.position) position.x.setConstant(test::kNaN);  // unused
    workspace.velocity = state.velocity;
  }

  void touch(std::int32_t vertex, double normal_force) {
    workspace.contacts.add(contact_key(0, vertex), vertex, 0, test::kNaN);
    workspace.contacts.normal_force.back() = normal_force;
    workspace.contacts.friction_force.back().setConstant(test::kNaN);
  }

  void solve(const std::string& rule) { friction_forces(scene, with_rule(rule), state, workspace); }

  Vec3& velocity(std::size_t vertex) { return workspace.velocity[vertex].v; }
  const Vec3& force(std::size_t contact) { return workspace.contacts.friction_force[contact]; }

  Scene scene;
  State state;
  Workspace workspace;
};

TEST_P(FrictionPhase, StickEndsTheSlip) {
  touch(1, 100.0);
  velocity(1) = Vec3(3, -4, -7);
  solve(GetParam());
  // One rounding of ũ and one of the force.
  EXPECT_LT(velocity(1).head<2>().norm(), 5 * 2 * test::kEpsilon);
  EXPECT_EQ(velocity(1).z(), -7.0) << "friction is tangential";
  EXPECT_EQ(state.obstacle_friction.status[0], ContactStatus::kStick);
  EXPECT_LT((force(0) - Vec3(-3, 4, 0) / kInverse).norm(), 40 * 2 * test::kEpsilon);
}

TEST_P(FrictionPhase, SlipLiesOnTheConeOppositeToTheSlip) {
  touch(1, 40.0);
  velocity(1) = Vec3(3, -4, -7);
  solve(GetParam());
  const double bound = 0.5 * 40.0;
  EXPECT_LT((force(0) - bound * Vec3(-0.6, 0.8, 0)).norm(), bound * 4 * test::kEpsilon);
  EXPECT_EQ(state.obstacle_friction.status[0], ContactStatus::kSlip);
  // Slows down by w f and goes on in the same direction: f ũ ≤ 0 and no overshoot.
  EXPECT_LT((velocity(1) - Vec3(1.5, -2, -7)).norm(), 10 * test::kEpsilon);
}

TEST_P(FrictionPhase, IsZeroWithoutFrictionCoefficient) {
  scene.half_spaces[0].friction = 0.0;
  touch(1, 100.0);
  velocity(1) = Vec3(3, -4, -7);
  solve(GetParam());
  EXPECT_EQ(force(0).norm(), 0.0);
  EXPECT_EQ(velocity(1), Vec3(3, -4, -7));
}

TEST_P(FrictionPhase, IsZeroWithoutNormalForce) {
  touch(1, 0.0);
  velocity(1) = Vec3(3, -4, 0);
  solve(GetParam());
  EXPECT_EQ(force(0).norm(), 0.0);
}

TEST_P(FrictionPhase, IsTangentialToATiltedPlane) {
  const Vec3 normal(0.6, 0.0, 0.8);
  scene.half_spaces[0].normal = normal;
  touch(2, 10.0);
  velocity(2) = 5.0 * Vec3(0.8, 0.0, -0.6) - 3.0 * normal;
  solve(GetParam());
  EXPECT_NEAR(force(0).dot(normal), 0.0, 5.0 * 4 * test::kEpsilon);
  EXPECT_NEAR(force(0).norm(), 5.0, 5.0 * 4 * test::kEpsilon);
  EXPECT_NEAR(velocity(2).dot(normal), -3.0, 5.0 * 4 * test::kEpsilon);
}

TEST_P(FrictionPhase, TouchesOnlyVerticesInContact) {
  for (std::size_t v = 0; v < 5; ++v) velocity(v) = Vec3(1, 0, 0);
  touch(3, 100.0);
  solve(GetParam());
  for (const std::size_t v : {0, 1, 2, 4}) EXPECT_EQ(velocity(v), Vec3(1, 0, 0));
}

TEST_P(FrictionPhase, CountsContactUpdates) {
  touch(0, 1.0);
  touch(2, 1.0);
  workspace.contact_updates = 5;
  solve(GetParam());
  EXPECT_EQ(workspace.contact_updates, 7u);
}

INSTANTIATE_TEST_SUITE_P(Rules, FrictionPhase, testing::ValuesIn(friction_rule_names()),
                         [](const auto& one) {
                           std::string name = one.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// ---- friction memory ----------------------------------------------------------------------------

class FrictionMemoryOfAStep : public FrictionPhase {
 protected:
  // Memory of contacts of the last step that all stuck; none of them slipped since, so that ξ
  // holds.
  void remember(std::vector<std::uint32_t> vertices, std::vector<double> xi) {
    for (const std::uint32_t v : vertices) {
      state.obstacle_friction.key.push_back(contact_key(0, v));
      state.obstacle_friction.status.push_back(ContactStatus::kStick);
    }
    state.obstacle_friction.value = std::move(xi);
  }
};

TEST_F(FrictionMemoryOfAStep, FollowsTheKeysWhenContactsAppearAndVanishBetween) {
  remember({0, 1, 3}, {0.5, 0.25, 0.75});
  for (const std::int32_t v : {1, 2, 3, 4}) touch(v, 100.0);  // 0 has gone, 2 and 4 are new
  for (std::size_t v = 0; v < 5; ++v) velocity(v) = Vec3(1, 0, 0);
  solve("fixed-point");
  EXPECT_EQ(state.obstacle_friction.key, workspace.contacts.key);
  EXPECT_EQ(state.obstacle_friction.value, (std::vector<double>{0.25, 1.0, 0.75, 1.0}));
  // … and each force is that of its own ξ: −ξ ũ/w.
  EXPECT_EQ(force(0).x(), -0.25 / kInverse);
  EXPECT_EQ(force(1).x(), -1.0 / kInverse);
  EXPECT_EQ(force(2).x(), -0.75 / kInverse);
  EXPECT_EQ(force(3).x(), -1.0 / kInverse);
}

TEST_F(FrictionMemoryOfAStep, TellsObstaclesApart) {
  scene.half_spaces.push_back(scene.half_spaces[0]);
  remember({1}, {0.25});
  workspace.contacts.add(contact_key(1, 1), 1, 1, test::kNaN);
  workspace.contacts.normal_force.back() = 100.0;
  velocity(1) = Vec3(1, 0, 0);
  solve("fixed-point");
  EXPECT_EQ(state.obstacle_friction.value, std::vector<double>{1.0});
}

TEST_F(FrictionMemoryOfAStep, IsForgottenOnSeparation) {
  remember({1}, {0.25});
  solve("fixed-point");  // a step without contact
  EXPECT_TRUE(state.obstacle_friction.key.empty());
  EXPECT_TRUE(state.obstacle_friction.value.empty());
  touch(1, 100.0);
  state.velocity[1].v = Vec3(0.5, 0, 0);  // would move ξ if the contact counted as stuck before
  velocity(1) = Vec3(1, 0, 0);
  solve("fixed-point");
  EXPECT_EQ(state.obstacle_friction.value, std::vector<double>{1.0});
}

TEST_F(FrictionMemoryOfAStep, UsesTheSlipAtTheStartOfTheStep) {
  remember({1}, {1.0});
  touch(1, 100.0);
  state.velocity[1].v = Vec3(0.5, 0, 9);  // u: its normal part is no slip
  velocity(1) = Vec3(1, 0, 0);            // ũ
  solve("fixed-point");
  EXPECT_DOUBLE_EQ(state.obstacle_friction.value[0], 1.0 + 0.7 * 0.5);
}

TEST_F(FrictionMemoryOfAStep, IsForgottenWhenTheContactSlips) {
  remember({1}, {0.25});
  touch(1, 1.0);
  velocity(1) = Vec3(10, 0, 0);
  solve("fixed-point");
  EXPECT_EQ(state.obstacle_friction.status[0], ContactStatus::kSlip);
  EXPECT_EQ(state.obstacle_friction.value, std::vector<double>{1.0});
}

TEST_F(FrictionMemoryOfAStep, OfAnotherRuleIsNotRead) {
  remember({1}, {});  // as the rule "none" leaves it: no values
  touch(1, 100.0);
  velocity(1) = Vec3(1, 0, 0);
  solve("fixed-point");
  EXPECT_EQ(state.obstacle_friction.value, std::vector<double>{1.0});
}

TEST_F(FrictionMemoryOfAStep, OfTheRuleNoneHoldsStatusesOnly) {
  touch(1, 100.0);
  velocity(1) = Vec3(1, 0, 0);
  solve("none");
  EXPECT_EQ(state.obstacle_friction.key.size(), 1u);
  EXPECT_TRUE(state.obstacle_friction.value.empty());
}

TEST_F(FrictionMemoryOfAStep, DemandsAKnownRule) { EXPECT_THROW(solve("magic"), std::logic_error); }

// Two bodies on the ground, and between them, with a friction of their own.
TEST(FrictionOfAPair, IsItsOwnAndLeavesTheOthersAsTheyAre) {
  SceneDescription description;
  for (int b = 0; b < 3; ++b) {
    description.bodies.push_back(
        test::point_masses(Eigen::Matrix3Xd::Constant(3, 1, static_cast<double>(b)), kMass));
  }
  description.half_spaces = {test::ground(0.5)};
  description.friction = 0.25;
  description.pair_friction = {{.body = 1, .other = 0, .against_body = false, .friction = 0.125},
                               {.body = 2, .other = 1, .against_body = true, .friction = 0.75}};
  const FrictionTable& own = build_scene(description).own_friction;
  ASSERT_FALSE(own.empty());
  EXPECT_EQ(own.against_obstacle(0, 0), Real(0.5));
  EXPECT_EQ(own.against_obstacle(1, 0), Real(0.125));
  EXPECT_EQ(own.against_obstacle(2, 0), Real(0.5));
  EXPECT_EQ(own.between(0, 1), Real(0.25));
  EXPECT_EQ(own.between(1, 2), Real(0.75));
  EXPECT_EQ(own.between(2, 1), Real(0.75));
  description.pair_friction.clear();
  EXPECT_TRUE(build_scene(description).own_friction.empty());
}

TEST_F(FrictionMemoryOfAStep, HasTheBoundOfThePair) {
  SceneDescription description =
      test::one_body(test::point_masses(Eigen::Matrix3Xd::Zero(3, 5), kMass));
  description.half_spaces = {test::ground(0.5)};
  description.pair_friction = {{.friction = 0.125}};
  scene = build_scene(description);
  touch(1, 8.0);
  velocity(1) = Vec3(10, 0, 0);
  solve("conjugate-vector");
  EXPECT_EQ(state.obstacle_friction.status[0], ContactStatus::kSlip);
  EXPECT_NEAR(force(0).norm(), 0.125 * 8.0, 1e-12);
}

}  // namespace
}  // namespace stiction
