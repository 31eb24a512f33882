// SPDX-License-Identifier: BSD-3-Clause
#include "solver/friction/rules/bias_vector.h"

#include <gtest/gtest.h>

#include "solver/friction/rules/aitken_vector.h"
#include "solver/testing/test_scenes.h"
#include "solver/testing/test_slips.h"

namespace stiction {
namespace {

using test::kInverseMass;
using test::stuck;

TEST(BiasVectorRule, OfAFreshContactIsTheClosedForm) {
  double memory[3] = {test::kNaN, test::kNaN, test::kNaN};
  const BiasVector rule({});
  rule.reset(memory);
  SlipProblem one = stuck(Vec3(3, -4, 0), Vec3::Constant(test::kNaN));  // u unused unless stuck
  one.was = ContactStatus::kNew;
  EXPECT_EQ(rule.solve(one, memory).force, Vec3(-12, 16, 0));
}

TEST(BiasVectorRule, LearnsSlipAcrossTheFreeSlipToo) {
  double memory[3] = {0, 0, 0};
  // u is across ũ: no scalar ξ could answer it.
  const SlipSolution solution =
      BiasVector(RuleSettings{{"gain", 0.5}}).solve(stuck(Vec3(1, 0, 0), Vec3(0, 0.2, 0)), memory);
  EXPECT_EQ(solution.status, ContactStatus::kStick);
  EXPECT_EQ(solution.force, Vec3(-4.0, -0.4, 0));
}

TEST(BiasVectorRule, LearnsOnceAStep) {
  double memory[3] = {0, 0, 0};
  SlipProblem later = stuck(Vec3(1, 0, 0), Vec3(0.2, 0, 0));
  later.first_sweep = false;
  BiasVector({}).solve(later, memory);
  EXPECT_EQ(memory[0], 0.0);
}

TEST(BiasVectorRule, LaysItsMemoryIntoTheTangentPlane) {
  double memory[3] = {1, 2, 3};
  const SlipSolution solution = BiasVector({}).solve(stuck(Vec3(0, 0, 0), Vec3::Zero()), memory);
  EXPECT_EQ(solution.force.z(), 0.0);
  EXPECT_EQ(memory[2], 0.0);
}

TEST(BiasVectorRule, ForgetsWhenClampedUnlessToldToKeep) {
  for (const bool keep : {false, true}) {
    double memory[3] = {0.5, 0, 0};
    const RuleSettings given{{"memory", keep ? 1.0 : 0.0}};
    const SlipSolution solution =
        BiasVector(given).solve(stuck(Vec3(3, -4, 0), Vec3::Zero(), 5.0), memory);
    EXPECT_EQ(solution.status, ContactStatus::kSlip);
    EXPECT_NEAR(solution.force.norm(), 5.0, 5.0 * 4 * test::kEpsilon);
    EXPECT_EQ(memory[0], keep ? 0.5 : 0.0);
  }
}

// What a loop leaves of ũ = (1, 0.5) when friction comes out too weak by the share ε, and turned by
// a quarter of that besides.
template <class Rule>
double slip_left(const Rule& rule, double artefact, int steps) {
  std::vector<double> memory(Rule::kValues);
  rule.reset(memory.data());
  const Vec3 free_slip(1.0, 0.5, 0.0);
  Vec3 slip = Vec3::Zero();
  ContactStatus was = ContactStatus::kNew;
  for (int k = 0; k < steps; ++k) {
    SlipProblem one = stuck(free_slip, slip);
    one.was = was;
    const SlipSolution solution = rule.solve(one, memory.data());
    was = solution.status;
    const Vec3 turned(-solution.force.y(), solution.force.x(), 0.0);
    slip =
        free_slip + kInverseMass * ((1.0 - artefact) * solution.force + 0.25 * artefact * turned);
  }
  return slip.norm();
}

TEST(BiasVectorRule, ConvergesInBothDirections) {
  // Per step the slip falls to |1 − 0.7 (0.7 ± 0.075 i)| = 0.52: 1e-16 takes 57 steps.
  EXPECT_LT(slip_left(BiasVector({}), 0.3, 70), 1e-15);
  EXPECT_GT(slip_left(BiasVector({}), 0.3, 10), 1e-6);
}

TEST(AitkenVectorRule, FindsAGainOfItsOwn) {
  // Faster than the bias vector, and from a gain for which that one needs ten times as long.
  EXPECT_LT(slip_left(AitkenVector({}), 0.3, 30), 1e-14);
  const RuleSettings timid{{"gain", 0.1}};
  EXPECT_LT(slip_left(AitkenVector(timid), 0.3, 30), 1e-12);
  EXPECT_GT(slip_left(BiasVector(timid), 0.3, 30), 1e-3);
}

TEST(AitkenVectorRule, ForgetsItsGainWhenClamped) {
  double memory[7] = {1, 0, 0, 1, 0, 0, 1.5};
  const SlipSolution solution =
      AitkenVector({}).solve(stuck(Vec3(3, -4, 0), Vec3::Zero(), 5.0), memory);
  EXPECT_EQ(solution.status, ContactStatus::kSlip);
  EXPECT_EQ(memory[0], 0.0);
  EXPECT_EQ(memory[6], parameter::kGain.initial);
}

}  // namespace
}  // namespace stiction
