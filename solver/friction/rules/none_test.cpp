// SPDX-License-Identifier: BSD-3-Clause
#include "solver/friction/rules/none.h"

#include <gtest/gtest.h>

#include "solver/testing/test_scenes.h"
#include "solver/testing/test_slips.h"

namespace stiction {
namespace {

SlipProblem problem(const Vec3& free_slip, double bound) {
  return {.free_slip = free_slip,
          .start_slip = Vec3::Constant(test::kNaN),  // unused by this rule
          .inverse_mass = test::kInverseMass,
          .bound = bound,
          .was = ContactStatus::kSlip};
}

SlipSolution solve(const SlipProblem& one) { return None({}).solve(one, nullptr); }

TEST(NoStabilisation, SticksWithTheForceThatEndsTheSlip) {
  const SlipSolution solution = solve(problem(Vec3(3, -4, 0), 21.0));
  EXPECT_EQ(solution.status, ContactStatus::kStick);
  EXPECT_EQ(solution.force, Vec3(-12, 16, 0));  // −ũ/w
}

TEST(NoStabilisation, SticksUpToTheBoundItself) {
  EXPECT_EQ(solve(problem(Vec3(3, -4, 0), 20.0)).status, ContactStatus::kStick);
  EXPECT_EQ(solve(problem(Vec3(3, -4, 0), 20.0 * (1.0 - test::kEpsilon))).status,
            ContactStatus::kSlip);
}

TEST(NoStabilisation, SlipsWithTheWholeBoundAgainstTheSlip) {
  const SlipSolution solution = solve(problem(Vec3(3, -4, 0), 10.0));
  EXPECT_EQ(solution.status, ContactStatus::kSlip);
  EXPECT_LT((solution.force - Vec3(-6, 8, 0)).norm(), 10.0 * 4 * test::kEpsilon);
}

TEST(NoStabilisation, GivesNoForceWithoutBoundOrWithoutSlip) {
  EXPECT_EQ(solve(problem(Vec3(3, -4, 0), 0.0)).force.norm(), 0.0);
  EXPECT_EQ(solve(problem(Vec3(3, -4, 0), 0.0)).status, ContactStatus::kSlip);
  EXPECT_EQ(solve(problem(Vec3::Zero(), 5.0)).force.norm(), 0.0);
  EXPECT_EQ(solve(problem(Vec3::Zero(), 0.0)).force.norm(), 0.0);
}

// λ f_max with λ = ũ/(ũ − u*) and u* = ũ + f_max w, equations (7)–(13) as printed.
TEST(NoStabilisation, IsThePapersStaticForceInClosedForm) {
  const SlipProblem one = problem(Vec3(3, -4, 0), 30.0);
  const Vec3 direction = one.free_slip.normalized();
  const double slip = one.free_slip.norm();
  const double with_friction = slip - one.bound * one.inverse_mass;
  ASSERT_LT(with_friction, 0.0) << "the sign turns, so the contact is static";
  const double lambda = slip / (slip - with_friction);
  EXPECT_LT((solve(one).force + lambda * one.bound * direction).norm(), 20 * 8 * test::kEpsilon);
}

}  // namespace
}  // namespace stiction
