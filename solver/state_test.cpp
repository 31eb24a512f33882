// SPDX-License-Identifier: BSD-3-Clause
#include "solver/state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "solver/step.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

State some_state() {
  BodyDescription body = test::elastic_body(test::corner_tetrahedron());
  body.initial_velocity = test::noise(4, 1.0, 1);
  State state = initial_state(build_scene(test::one_body(body)));
  state.step = 3;
  state.obstacle_friction = {{1, 2}, {ContactStatus::kStick, ContactStatus::kSlip}, {0.5, 1.5}};
  return state;
}

TEST(InitialState, IsTheScenesOwn) {
  BodyDescription body = test::elastic_body(test::cube_mesh(1));
  body.initial_velocity = test::noise(8, 1.0, 2);
  body.pinned = {3};
  const Scene scene = build_scene(test::one_body(body));
  const State state = initial_state(scene);
  EXPECT_EQ(state.step, 0u);
  EXPECT_TRUE(state.obstacle_friction.key.empty());
  ASSERT_EQ(state.position.size(), 8u);
  for (std::size_t k = 0; k < 8; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    EXPECT_EQ(state.position[k].x, Vec3(scene.rest_position.col(column)));
    EXPECT_EQ(state.velocity[k].v, Vec3(scene.initial_velocity.col(column)));
    EXPECT_EQ(state.velocity[k].inverse_mass, scene.inverse_mass[k]);
  }
}

struct Change {
  std::string name;
  std::function<void(State&)> make;
};

void PrintTo(const Change& change, std::ostream* out) { *out << change.name; }

class HashOfAState : public testing::TestWithParam<Change> {};

TEST_P(HashOfAState, ChangesWith) {
  State state = some_state();
  const std::uint64_t before = hash_of(state);
  GetParam().make(state);
  EXPECT_NE(hash_of(state), before);
}

INSTANTIATE_TEST_SUITE_P(
    Parts, HashOfAState,
    testing::Values(
        Change{"TheStepCount", [](State& s) { ++s.step; }},
        Change{"TheLastBitOfAPosition",
               [](State& s) { s.position[3].x.z() = std::nextafter(s.position[3].x.z(), 9.0); }},
        Change{"TheLastBitOfAVelocity",
               [](State& s) { s.velocity[0].v.x() = std::nextafter(s.velocity[0].v.x(), 9.0); }},
        Change{"AContactKey", [](State& s) { s.obstacle_friction.key[1] = 7; }},
        Change{"AContactStatus",
               [](State& s) { s.obstacle_friction.status[0] = ContactStatus::kSlip; }},
        Change{"AMemoryValue",
               [](State& s) { s.obstacle_friction.value[1] = std::nextafter(1.5, 2.0); }},
        Change{"AContactMore",
               [](State& s) {
                 s.obstacle_friction.key.push_back(3);
                 s.obstacle_friction.status.push_back(ContactStatus::kNew);
                 s.obstacle_friction.value.push_back(1.0);
               }}),
    [](const auto& one) { return one.param.name; });

TEST(HashOfState, LeavesOutThePadding) {
  State state = some_state();
  const std::uint64_t before = hash_of(state);
  for (Position& position : state.position) position.unused = test::kNaN;
  EXPECT_EQ(hash_of(state), before);
}

// A soft cube that settles on a slope of friction.
Scene settling_cube() {
  SceneDescription description =
      test::one_body(test::elastic_body(test::cube_mesh(2, 0.1), {1000.0, 1e5, 0.3, 1e-4}));
  description.half_spaces = {test::ground(0.5)};
  description.gravity = {{0.0}, {Vec3(2.0, 1.0, -9.81)}};
  return build_scene(description);
}

void advance(const Scene& scene, State& state, Workspace& workspace, int steps) {
  const Options options{.time_step = 2e-4, .rule = "fixed-point"};
  check_options(options, scene);
  for (int k = 0; k < steps; ++k) step(scene, options, state, workspace);
}

TEST(ASavedState, ReplaysToTheSameHashWithItsFrictionMemory) {
  const Scene scene = settling_cube();
  State state = initial_state(scene);
  Workspace workspace;
  advance(scene, state, workspace, 300);
  ASSERT_FALSE(state.obstacle_friction.value.empty());
  // Something that a fresh memory would not hold: contacts that learned to push less.
  for (double& xi : state.obstacle_friction.value) xi = 0.9;
  const State saved = state;

  advance(scene, state, workspace, 200);
  const std::uint64_t first = hash_of(state);

  state = saved;
  EXPECT_EQ(hash_of(state), hash_of(saved));
  advance(scene, state, workspace, 200);
  EXPECT_EQ(hash_of(state), first);

  State elsewhere = saved;
  Workspace fresh;
  advance(scene, elsewhere, fresh, 200);
  EXPECT_EQ(hash_of(elsewhere), first) << "nothing in a workspace is needed to continue";

  State forgetful = saved;
  forgetful.obstacle_friction = {};
  advance(scene, forgetful, fresh, 200);
  EXPECT_NE(hash_of(forgetful), first) << "the memory is part of the state";
}

TEST(HashOf, AStateThatIsNoNumberIsTheSameWhateverKindOfNaN) {
  const Scene scene =
      build_scene(test::one_body(test::point_masses(Eigen::Matrix3Xd::Zero(3, 1), 1.0)));
  State plus = initial_state(scene);
  State minus = plus;
  plus.position[0].x[1] = test::kNaN;
  minus.position[0].x[1] = std::copysign(test::kNaN, -1.0);
  EXPECT_EQ(hash_of(plus), hash_of(minus));
  EXPECT_NE(hash_of(plus), hash_of(initial_state(scene)));
  minus.velocity[0].v[0] = test::kNaN;
  EXPECT_NE(hash_of(plus), hash_of(minus));
}

}  // namespace
}  // namespace stiction
