// SPDX-License-Identifier: BSD-3-Clause
#include "solver/friction/rules/fixed_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "solver/testing/test_scenes.h"
#include "solver/testing/test_slips.h"

namespace stiction {
namespace {

using test::kInverseMass;
using test::stuck;

TEST(FixedPointRule, StartsWithOne) {
  double xi = test::kNaN;
  FixedPoint({}).reset(&xi);
  EXPECT_EQ(xi, 1.0);
}

TEST(FixedPointRule, OfAFreshContactIsTheClosedForm) {
  double xi = 1.0;
  SlipProblem one = stuck(Vec3(3, -4, 0), Vec3::Constant(test::kNaN));  // u unused unless stuck
  one.was = ContactStatus::kNew;
  const SlipSolution solution = FixedPoint({}).solve(one, &xi);
  EXPECT_EQ(solution.status, ContactStatus::kStick);
  EXPECT_EQ(solution.force, Vec3(-12, 16, 0));
  EXPECT_EQ(xi, 1.0);
}

TEST(FixedPointRule, RaisesXiByGainTimesTheRelativeSlipThatIsLeft) {
  double xi = 1.0;
  // u along ũ counts in the ratio 1 : 5, across it not at all.
  const SlipProblem one = stuck(Vec3(3, -4, 0), 0.2 * Vec3(3, -4, 0) + Vec3(4, 3, 0));
  const SlipSolution solution = FixedPoint(RuleSettings{{"gain", 0.5}}).solve(one, &xi);
  EXPECT_NEAR(xi, 1.1, 4 * test::kEpsilon);
  EXPECT_LT((solution.force - 1.1 * Vec3(-12, 16, 0)).norm(), 22 * 4 * test::kEpsilon);
}

TEST(FixedPointRule, LowersXiWhenTheSlipTurnedBack) {
  double xi = 1.0;
  FixedPoint(RuleSettings{{"gain", 0.5}}).solve(stuck(Vec3(3, -4, 0), -0.2 * Vec3(3, -4, 0)), &xi);
  EXPECT_NEAR(xi, 0.9, 4 * test::kEpsilon);
}

TEST(FixedPointRule, WithRawAlphaSubtractsAlphaTimesTheSlipItself) {
  double xi = 1.0;
  // α in s/m: −0.1 · 1 m/s, whatever |ũ| is; the gain is unused.
  const FixedPoint rule(RuleSettings{{"gain", test::kNaN}, {"alpha", -0.1}});
  rule.solve(stuck(Vec3(30, -40, 0), Vec3(0.6, -0.8, 0)), &xi);
  EXPECT_NEAR(xi, 1.1, 4 * test::kEpsilon);
}

TEST(FixedPointRule, HoldsXiWhereTheFreeSlipHasNoDirection) {
  for (const double slip : {0.0, 1e-300, 1e-13}) {
    double xi = 1.25;
    const SlipSolution solution = FixedPoint({}).solve(stuck(Vec3(slip, 0, 0), Vec3(1, 1, 0)), &xi);
    EXPECT_EQ(xi, 1.25) << slip;
    EXPECT_EQ(solution.status, ContactStatus::kStick) << slip;
    EXPECT_NEAR(solution.force.x(), -1.25 * slip / kInverseMass, slip * 10 * test::kEpsilon);
  }
}

TEST(FixedPointRule, LimitsTheForceToTheConeAndThenSlips) {
  double xi = 1.5;
  // −ũ/w = 20 N could stick within 24 N, but ξ asks for 30 N.
  const SlipSolution solution =
      FixedPoint({}).solve(stuck(Vec3(3, -4, 0), Vec3::Zero(), 24.0), &xi);
  EXPECT_EQ(solution.status, ContactStatus::kSlip);
  EXPECT_LT((solution.force - 24.0 * Vec3(-0.6, 0.8, 0)).norm(), 24 * 4 * test::kEpsilon);
}

TEST(FixedPointRule, ForgetsXiWhenItSlips) {
  double clamped = 1.5;
  FixedPoint({}).solve(stuck(Vec3(3, -4, 0), Vec3::Zero(), 24.0), &clamped);
  EXPECT_EQ(clamped, 1.0) << "clamped";
  double dynamic = 1.5;
  FixedPoint({}).solve(stuck(Vec3(3, -4, 0), Vec3(3, -4, 0), 10.0), &dynamic);
  EXPECT_EQ(dynamic, 1.0) << "beyond the cone, where it would have wound up";
}

TEST(FixedPointRule, LearnsNothingWhileSlipping) {
  double xi = 1.0;
  SlipProblem one = stuck(Vec3(3, -4, 0), Vec3(3, -4, 0));
  one.was = ContactStatus::kSlip;  // the last step's slip is no error of ξ
  FixedPoint({}).solve(one, &xi);
  EXPECT_EQ(xi, 1.0);
}

// ---- the loop that it closes ------------------------------------------------------------------

// What a loop does with the slip that friction leaves: |u| after so many steps, over |ũ|.
using Loop = double (*)(const FixedPoint& rule, double artefact, int steps);

// The slip that a rule leaves of ũ = 1 m/s when a share ε of its force gets lost.
double slip_left(const FixedPoint& rule, double start_slip, double artefact, double* xi) {
  const SlipSolution solution = rule.solve(stuck(Vec3(0, 1, 0), Vec3(0, start_slip, 0)), xi);
  EXPECT_EQ(solution.status, ContactStatus::kStick);
  return 1.0 + kInverseMass * (1.0 - artefact) * solution.force.y();
}

// u = ũ (1 − ξ(1 − ε)): ξ ← ξ + g (1 − ξ(1 − ε)) has the factor 1 − g(1 − ε).
double lossy_loop(const FixedPoint& rule, double artefact, int steps) {
  double xi = 1.0;
  double u = artefact;
  for (int k = 0; k < steps; ++k) u = slip_left(rule, u, artefact, &xi);
  return std::abs(u);
}

// u_{k+1} = ũ (1 − ξ_{k+1}) − ε u_k, the artefact being an echo of the last slip:
// z² − (1 − ε − g) z − ε = 0.
double echoing_loop(const FixedPoint& rule, double artefact, int steps) {
  double xi = 1.0;
  double u = 0.1;
  for (int k = 0; k < steps; ++k) u = slip_left(rule, u, 0.0, &xi) - artefact * u;
  return std::abs(u);
}

struct Gain {
  std::string name;
  Loop loop;
  double artefact;
  double limit;  // of the gain: stable for 0 < g < limit
};

void PrintTo(const Gain& gain, std::ostream* out) { *out << gain.name; }

class FixedPointLoop : public testing::TestWithParam<Gain> {};

TEST_P(FixedPointLoop, ConvergesForGainsBelowTheLimit) {
  for (const double fraction : {0.05, 0.35, 0.7, 0.95}) {
    const FixedPoint rule(RuleSettings{{"gain", fraction * GetParam().limit}});
    // The slowest factor is 0.95 or |1 − 0.95 · 2| = 0.9 a step and more with an echo: 0.98^2000.
    EXPECT_LT(GetParam().loop(rule, GetParam().artefact, 2000), 1e-14) << fraction;
  }
}

TEST_P(FixedPointLoop, DivergesForGainsBeyondTheLimitAndOfTheWrongSign) {
  const FixedPoint beyond(RuleSettings{{"gain", 1.05 * GetParam().limit}});
  EXPECT_GT(GetParam().loop(beyond, GetParam().artefact, 150), 10.0);
  const FixedPoint wrong(RuleSettings{{"gain", -0.05 * GetParam().limit}});
  EXPECT_GT(GetParam().loop(wrong, GetParam().artefact, 150), 10.0);
}

INSTANTIATE_TEST_SUITE_P(Artefacts, FixedPointLoop,
                         testing::Values(Gain{"Lossy10Percent", lossy_loop, 0.1, 2.0 / 0.9},
                                         Gain{"Lossy30Percent", lossy_loop, 0.3, 2.0 / 0.7},
                                         Gain{"Echo10Percent", echoing_loop, 0.1, 2.0 * 0.9},
                                         Gain{"Echo30Percent", echoing_loop, 0.3, 2.0 * 0.7}),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace stiction
