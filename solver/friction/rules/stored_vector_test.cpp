// SPDX-License-Identifier: BSD-3-Clause
#include "solver/friction/rules/stored_vector.h"

#include <gtest/gtest.h>

#include "solver/testing/test_scenes.h"
#include "solver/testing/test_slips.h"

namespace stiction {
namespace {

using test::kInverseMass;

SlipProblem problem(const Vec3& free_slip, const Vec3& force, double bound) {
  return {.free_slip = free_slip,
          .start_slip = Vec3::Constant(test::kNaN),  // this rule does not look back at velocities
          .inverse_mass = kInverseMass,
          .bound = bound,
          .force = force};
}

TEST(StoredVectorRule, StartsFromNothingAndRemembersItsForce) {
  double memory[3] = {test::kNaN, test::kNaN, test::kNaN};
  const StoredVector rule({});
  rule.reset(memory);
  EXPECT_EQ(rule.start(memory), Vec3::Zero());
  const SlipSolution solution = rule.solve(problem(Vec3(3, -4, 0), Vec3::Zero(), 1e9), memory);
  EXPECT_EQ(solution.force, Vec3(-12, 16, 0));
  EXPECT_EQ(solution.status, ContactStatus::kStick);
  EXPECT_EQ(rule.start(memory), solution.force);
}

TEST(StoredVectorRule, ChangesNothingWhenItsForceAlreadyEndsTheSlip) {
  double memory[3] = {0, 0, 0};
  const Vec3 force(1, 2, 0);
  const Vec3 free_slip = -kInverseMass * force;
  EXPECT_EQ(StoredVector({}).solve(problem(free_slip, force, 1e9), memory).force, force);
}

TEST(StoredVectorRule, AtTheConeIsCoulombsSlidingWhateverItHeldBefore) {
  double memory[3] = {0, 0, 0};
  const Vec3 free_slip(0.3, -0.4, 0.0);
  for (const Vec3& before : {Vec3(0, 0, 0), Vec3(0.6, 0.8, 0), Vec3(-1, 0, 0)}) {
    const SlipSolution solution = StoredVector({}).solve(problem(free_slip, before, 1.0), memory);
    EXPECT_EQ(solution.status, ContactStatus::kSlip);
    // Two roundings of a unit vector.
    EXPECT_LT((solution.force + free_slip / 0.5).norm(), 1e-15);
  }
}

TEST(StoredVectorRule, OverRelaxesByOmega) {
  double memory[3] = {0, 0, 0};
  const RuleSettings given{{"relaxation", 1.25}};
  const SlipSolution solution =
      StoredVector(given).solve(problem(Vec3(1, 0, 0), Vec3::Zero(), 1e9), memory);
  EXPECT_EQ(solution.force, Vec3(-5, 0, 0));
}

}  // namespace
}  // namespace stiction
