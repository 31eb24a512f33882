// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/motion/rolling_balls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace stiction::reference {
namespace {

constexpr double kGravity = 9.81;  // m/s²

// The paper's Fig. 7 with smooth balls: three of radius r that touch, one 1.75 times as large in
// the hollow between them, all of one density.
std::vector<RigidBall> four_balls() {
  const double r = 0.1, ratio = 1.75;
  const double spread = 2.0 * r / std::numbers::sqrt3;
  const double rise = std::sqrt(std::pow((1.0 + ratio) * r, 2) - spread * spread);
  std::vector<RigidBall> balls;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 3.0;
    balls.push_back({{spread * std::cos(angle), spread * std::sin(angle), r}, r, 1.0});
  }
  balls.push_back({{0.0, 0.0, r + rise}, ratio * r, std::pow(ratio, 3)});
  return balls;
}

TEST(RollingBalls, FourNeedThePapersFrictionAndRollFreely) {
  const RollingMotions motions =
      rolling_motions(four_balls(), {{0, 3}, {1, 3}, {2, 3}, {-1, 0}, {-1, 1}, {-1, 2}}, kGravity);
  EXPECT_LT(motions.residual, 1e-12);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(motions.friction[k], 0.2201, 5e-5) << "between balls";
    EXPECT_NEAR(motions.friction[3 + k], 0.1411, 5e-5) << "on the ground";
  }
  // 24 velocities, 18 conditions of no slip: six motions are left, and gravity neither drives nor
  // opposes one of them. A rate that mattered would be g/r = 98 1/s²; the differences are good to
  // 1e-9 of that.
  ASSERT_EQ(motions.rates2.size(), 6);
  EXPECT_LT(motions.rates2.cwiseAbs().maxCoeff(), 1e-6);
}

TEST(RollingBalls, FourDoNotSinkWithoutSlip) {
  // To first order the top ball sinks in none of the six: what sinks from here slips first. (The
  // lower ones may move against each other.)
  const RollingMotions motions =
      rolling_motions(four_balls(), {{0, 3}, {1, 3}, {2, 3}, {-1, 0}, {-1, 1}, {-1, 2}}, kGravity);
  ASSERT_EQ(motions.basis.rows(), 24);
  EXPECT_LT(motions.basis.row(6 * 3 + 2).cwiseAbs().maxCoeff(),
            1e-12 * motions.basis.cwiseAbs().maxCoeff());
}

TEST(RollingBalls, OneOnTopOfAnotherFallsOff) {
  // A ball balanced on one that rolls: its fastest motion grows like an inverted pendulum.
  const double r = 0.1;
  const RollingMotions motions = rolling_motions(
      {{{0.0, 0.0, r}, r, 1.0}, {{0.0, 0.0, 3.0 * r}, r, 1.0}}, {{-1, 0}, {0, 1}}, kGravity);
  EXPECT_LT(motions.residual, 1e-12);
  EXPECT_GT(motions.rates2.maxCoeff(), 0.1 * kGravity / r);
}

TEST(RollingBalls, ThatDoNotTouchAreRefused) {
  EXPECT_THROW(rolling_motions({{{0.0, 0.0, 0.2}, 0.1, 1.0}}, {{-1, 0}}, kGravity),
               std::invalid_argument);
}

}  // namespace
}  // namespace stiction::reference
