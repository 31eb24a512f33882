// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/limit/limit_analysis.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "reference/limit/limit_scenes.h"

namespace stiction::reference {
namespace {

using Eigen::Vector3d;

constexpr double kGravity = 9.81;
// Both ends are proved up to the residual allowed (1e-9 of the weight) times the conditioning of
// the threshold, which is below 100 in these scenes.
constexpr double kProof = 1e-7;

void expect_contains(const LimitBracket& bracket, double expected, double width = 1e-6) {
  EXPECT_LE(bracket.lower, expected + kProof);
  EXPECT_GE(bracket.upper, expected - kProof);
  EXPECT_LE(bracket.upper - bracket.lower, width + kProof);
}

class Friction : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Mu, Friction, testing::Values(0.05, 0.3, 0.7), [](const auto& parameter) {
  return "mu_" + std::to_string(std::lround(100 * parameter.param)) + "_percent";
});

TEST_P(Friction, BoxSlidesAtTangentEqualToMu) {  // analytic
  const LimitProblem box = box_on_incline({1.0, 0.4, 1.0}, 3.0);
  expect_contains(critical_load(box, GetParam()), GetParam());
  expect_contains(critical_friction(box, GetParam()), GetParam());
}

TEST_P(Friction, ConeIsRoundWhereTheSlipIsNotAlongAnEdge) {  // analytic: √(0.04² + λ²) = μ
  LimitProblem box = box_on_incline({1.0, 1.0, 0.5}, 1.0);
  box.gravity = Vector3d(0.0, 0.04 * kGravity, -kGravity);
  const double expected = std::sqrt(GetParam() * GetParam() - 0.0016);
  expect_contains(critical_load(box, GetParam()), expected);
  // Polygons within 0.5 % of the circle: a mechanism tested against a wrong cone shows up.
  expect_contains(critical_load(box, GetParam(), {.facets = 32}), expected);
}

TEST(LimitAnalysis, BoxTopplesAtWidthOverHeight) {  // analytic
  expect_contains(critical_load(box_on_incline({0.5, 1.0, 1.0}, 1.0), 3.0), 0.5);
  expect_contains(critical_load(box_on_incline({1.0, 1.0, 4.0}, 1.0), 3.0), 0.25);
}

TEST(LimitAnalysis, FourBallsHaveTheSmoothThresholds) {        // analytic
  EXPECT_NEAR(four_ball_thresholds(1.75).ball, 0.2201, 5e-5);  // four printed digits
  EXPECT_NEAR(four_ball_thresholds(1.75).ground, 0.1411, 5e-5);
  EXPECT_NEAR(four_ball_thresholds(1.0).ball, std::sqrt(3.0) - std::sqrt(2.0), 1e-15);
  for (const double ratio : {1.0, 1.3, 1.75, 3.0}) {
    const FourBallThresholds expected = four_ball_thresholds(ratio);
    expect_contains(critical_friction(four_ball_pyramid(ratio, 10.0)), expected.ball);
    // With μ_ground = μ/10 the ground decides, at ten times its threshold.
    expect_contains(critical_friction(four_ball_pyramid(ratio, 0.1)), 10.0 * expected.ground, 2e-6);
  }
}

TEST(LimitAnalysis, BoxPyramidSlidesAtMuAndTopplesLater) {
  const double toppling[] = {1.0, 11.0 / 14.0, 33.0 / 47.0, 0.0, 0.63};  // exact-computed
  for (int rows = 1; rows <= 5; ++rows) {
    const LimitProblem pyramid = box_pyramid(rows, 0.0, false);
    expect_contains(critical_load(pyramid, 0.3), 0.3);
    const LimitBracket rough = critical_load(pyramid, 3.0);
    EXPECT_LE(rough.upper - rough.lower, 1e-6);
    if (rows <= 3) expect_contains(rough, toppling[rows - 1]);
    if (rows == 5) {
      EXPECT_NEAR(rough.lower, toppling[rows - 1], 5e-3);  // two printed digits
    }
  }
}

TEST(LimitAnalysis, NeighboursThatTouchHoldEachOtherUp) {
  // The wall of cubes then leans as one: no joint opens before the slope of a single cube.
  expect_contains(critical_load(box_pyramid(3, 0.0, true), 3.0), 1.0, 2e-6);
}

/// `count` unit cubes in a row along x between fixed jaws that press with `force` in all.
LimitProblem clamped_row(int count, double force) {
  LimitProblem row;
  PrescribedNormalForce clamp{{}, force};
  for (int k = 0; k <= count; ++k) {
    if (k < count) row.bodies.push_back({2.0, Vector3d(k, 0.0, 0.0)});
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) {
        const bool last = k == count;
        if (k == 0) clamp.contacts.push_back(static_cast<int>(row.contacts.size()));
        row.contacts.push_back({last ? k - 1 : k, last ? kFixed : k - 1, Vector3d(k - 0.5, y, z),
                                Vector3d(last ? -1.0 : 1.0, 0.0, 0.0), 1.0});
      }
    }
  }
  row.clamps = {clamp};
  row.gravity.setZero();
  row.live_gravity = Vector3d(0.0, 0.0, -kGravity);
  return row;
}

TEST_P(Friction, ClampedRowHoldsIfPressedEnough) {  // analytic: N ≥ n m g / (2 μ)
  for (const int count : {1, 2, 3}) {
    const double force = 100.0;
    expect_contains(critical_load(clamped_row(count, force), GetParam()),
                    2.0 * GetParam() * force / (count * 2.0 * kGravity));
  }
}

TEST(LimitAnalysis, OffsetBarsTakeTheirShareOfFriction) {  // N ≥ m g / (2 (μ − Δh/w))
  LimitProblem box = clamped_row(1, 100.0);
  for (ContactPoint& contact : box.contacts)
    contact.point.z() = contact.normal.x() > 0 ? 0.1 : -0.1;
  const double expected = 2.0 * (0.5 - 0.2) * 100.0 / (2.0 * kGravity);
  expect_contains(critical_load(box, 0.5), expected, 1e-5);
}

TEST(LimitAnalysis, ProofsCanBeCheckedByHand) {
  const LimitProblem balls = four_ball_pyramid(1.75, 1.0);
  const double critical = four_ball_thresholds(1.75).ball;
  const LimitFeasibility stands = equilibrium(balls, critical + 1e-5);
  ASSERT_EQ(stands.answer, Equilibrium::exists);
  const double weight = kGravity * (3.0 + std::pow(1.75, 3));
  Vector3d ground = Vector3d::Zero();
  for (int c = 0; c < 6; ++c) {
    const ContactPoint& contact = balls.contacts[static_cast<std::size_t>(c)];
    const Vector3d force = stands.forces.col(c);
    const double normal = force.dot(contact.normal);
    EXPECT_LE((force - normal * contact.normal).norm(), (critical + 1e-5) * normal * (1 + 1e-12));
    if (contact.body_b == kFixed) ground += force;
  }
  EXPECT_NEAR(ground.z(), weight, 1e-8 * weight);  // the residual allowed, with room for scaling
  EXPECT_NEAR(ground.head<2>().norm(), 0.0, 1e-8 * weight);

  const LimitFeasibility falls = equilibrium(balls, critical - 1e-5);
  ASSERT_EQ(falls.answer, Equilibrium::none);
  double power = 0.0;
  for (int b = 0; b < 4; ++b) {
    power -= balls.bodies[static_cast<std::size_t>(b)].mass * kGravity * falls.mechanism(2, b);
  }
  EXPECT_GT(power, 0.0);  // the load does work …
  EXPECT_LT(falls.mechanism(2, 0), 0.0);
  const double largest = falls.mechanism.cwiseAbs().maxCoeff();
  for (const ContactPoint& contact : balls.contacts) {  // … and no force in a cone takes any away
    const auto velocity = [&](int body) -> Vector3d {
      if (body == kFixed) return Vector3d::Zero();
      const Vector3d arm =
          contact.point - balls.bodies[static_cast<std::size_t>(body)].center_of_mass;
      const Vector3d spin = falls.mechanism.col(body).tail<3>();
      return falls.mechanism.col(body).head<3>() + spin.cross(arm);
    };
    const Vector3d v = velocity(contact.body_a) - velocity(contact.body_b);
    const double normal = v.dot(contact.normal);
    const double sliding = (v - normal * contact.normal).norm();
    // What the proof's margin of 1e-5 in μ leaves to a thousand weights of normal force.
    EXPECT_GE(normal, (critical - 1e-5) * sliding - 1e-8 * largest);
  }
}

TEST(LimitAnalysis, ExactSimplexOverPolygonsAgrees) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int trial = 0; trial < 10; ++trial) {
    LimitProblem stool;  // a body on four random props with random normals
    stool.bodies = {{1.0, Vector3d(0.2 * uniform(generator), 0.2 * uniform(generator), 0.5)}};
    for (int k = 0; k < 4; ++k) {
      const Vector3d point(k % 2 == 0 ? -1.0 : 1.0, k < 2 ? -1.0 : 1.0, 0.3 * uniform(generator));
      const Vector3d tilted(0.3 * uniform(generator), 0.3 * uniform(generator), 1.0);
      stool.contacts.push_back({0, kFixed, point, tilted.normalized(), 1.0});
    }
    stool.live_gravity = Vector3d(kGravity, 0.3 * kGravity, 0.0);
    const LimitBracket round = critical_load(stool, 0.4);
    const LimitBracket polygons = polygonal_critical_load(stool, 0.4);
    // The residual of 1e-9 moves both; inscribed ≤ round ≤ circumscribed.
    EXPECT_LE(polygons.lower, round.upper + kProof) << "trial " << trial;
    EXPECT_GE(polygons.upper, round.lower - kProof) << "trial " << trial;
    EXPECT_LE(round.upper - round.lower, 1e-5) << "trial " << trial;
    EXPECT_GT(round.lower, 0.0);
    // Eight facets lose at most 1 − cos²(π/8) = 15 % of the friction.
    EXPECT_LT(polygons.upper - polygons.lower, 0.5 * round.upper);
  }
  const LimitBracket two_rows = polygonal_critical_load(box_pyramid(2, 0.0, false), 3.0);
  EXPECT_NEAR(two_rows.lower, 11.0 / 14.0, kProof);
}

TEST(LimitAnalysis, NoEquilibriumAtAllAndNoLimitAtAll) {
  LimitProblem box = box_on_incline({1.0, 1.0, 1.0}, 1.0);
  box.bodies[0].center_of_mass.x() = 0.6;  // beyond the edge: falls whatever μ is
  EXPECT_EQ(critical_load(box, 5.0).upper, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(critical_friction(box).lower, std::numeric_limits<double>::infinity());
  box.bodies[0].center_of_mass.x() = 0.0;
  box.live_gravity = Vector3d(0.0, 0.0, -kGravity);
  EXPECT_EQ(critical_load(box, 0.1).lower, std::numeric_limits<double>::infinity());
  EXPECT_EQ(critical_friction(box).upper, 0.0);
}

TEST(LimitAnalysis, RefusesWhatMakesNoSense) {
  const LimitProblem good = box_on_incline({1.0, 1.0, 1.0}, 1.0);
  EXPECT_THROW(critical_load({}, 0.3), std::invalid_argument);
  EXPECT_THROW(critical_load(good, -0.1), std::invalid_argument);
  EXPECT_THROW(critical_load(good, 0.3, {.facets = 5}), std::invalid_argument);
  LimitProblem bad = good;
  bad.contacts[0].normal *= 1.1;
  EXPECT_THROW(equilibrium(bad, 0.3), std::invalid_argument);
  bad = good;
  bad.contacts[0].body_b = 0;
  EXPECT_THROW(equilibrium(bad, 0.3), std::invalid_argument);
  bad = good;
  bad.bodies[0].mass = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(equilibrium(bad, 0.3), std::invalid_argument);
}

TEST(InNineDigits, HidesTheLastBits) {
  EXPECT_EQ(in_nine_digits(9.81 * (1.0 + 1e-15)), in_nine_digits(9.81 * (1.0 - 1e-15)));
  EXPECT_EQ(in_nine_digits(0.3 + 1e-13), 0.3);
  EXPECT_DOUBLE_EQ(in_nine_digits(-123456.789123), -123456.789);
  EXPECT_EQ(in_nine_digits(0.0), 0.0);
}

}  // namespace
}  // namespace stiction::reference
