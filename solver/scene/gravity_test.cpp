// SPDX-License-Identifier: BSD-3-Clause
#include "solver/scene/gravity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stiction {
namespace {

const Gravity kRamp{{1.0, 3.0, 4.0}, {{0, 0, 0}, {0, 2, -8}, {1, 2, -8}}};

TEST(Gravity, WithoutKeyframesIsWeightlessness) { EXPECT_EQ(Gravity{}.at(1.0), Vec3::Zero()); }

TEST(Gravity, WithOneKeyframeIsConstant) {
  const Gravity gravity{{5.0}, {{1, 2, 3}}};
  for (const double t : {-1.0, 5.0, 100.0}) EXPECT_EQ(gravity.at(t), Vec3(1, 2, 3)) << t;
}

TEST(Gravity, IsExactAtItsKeyframesAndConstantOutsideThem) {
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(kRamp.at(kRamp.time[k]), kRamp.acceleration[k]) << "keyframe " << k;
  }
  EXPECT_EQ(kRamp.at(-10.0), kRamp.acceleration.front());
  EXPECT_EQ(kRamp.at(10.0), kRamp.acceleration.back());
}

TEST(Gravity, FollowsTheSmoothStepBetweenThem) {
  // 6s⁵ − 15s⁴ + 10s³ at s = ¼, ½, ¾: 53/512, ½, 459/512; powers of two, so nothing is rounded.
  EXPECT_EQ(kRamp.at(1.5), 53.0 / 512.0 * Vec3(0, 2, -8));
  EXPECT_EQ(kRamp.at(2.0), 0.5 * Vec3(0, 2, -8));
  EXPECT_EQ(kRamp.at(2.5), 459.0 / 512.0 * Vec3(0, 2, -8));
  EXPECT_EQ(kRamp.at(3.5), Vec3(0.5, 2, -8));
}

// Derivatives on either side of a keyframe, by one-sided differences.
double rate(double t, double h) { return (kRamp.at(t + h).z() - kRamp.at(t).z()) / h; }
double curvature(double t, double h) {
  return (kRamp.at(t + 2.0 * h).z() - 2.0 * kRamp.at(t + h).z() + kRamp.at(t).z()) / (h * h);
}

TEST(Gravity, IsTwiceContinuouslyDifferentiableAtItsKeyframes) {
  // Near a keyframe the ramp is 10 s³ Δg with s = h/2, Δg = 8 m/s²: rates are below 3·10·8/8 · h²
  // and curvatures, over 2h, below 6·10·8/8 · 2h.
  const double h = 1e-3;
  for (const double t : {1.0, 3.0}) {
    for (const double side : {-h, h}) {
      EXPECT_LE(std::abs(rate(t, side)), 30.0 * h * h) << "at " << t << ", side " << side;
      EXPECT_LE(std::abs(curvature(t, side)), 120.0 * h) << "at " << t << ", side " << side;
    }
  }
  // Not by being flat: between keyframes the rate reaches 15/8 Δg/(2 s), up to its curvature h²/24.
  EXPECT_NEAR((kRamp.at(2.0 + h).z() - kRamp.at(2.0 - h).z()) / (2.0 * h), -7.5, 1e-4);
}

TEST(Drag, IsFullThenFadesAndIsGone) {
  EXPECT_EQ(Drag{}.at(0.0), 0.0);
  const Drag drag{8.0, 1.0, 3.0};
  EXPECT_EQ(drag.at(0.0), 8.0);
  EXPECT_EQ(drag.at(1.0), 8.0);
  EXPECT_EQ(drag.at(2.0), 4.0);
  EXPECT_EQ(drag.at(3.0), 0.0);
  EXPECT_EQ(drag.at(9.0), 0.0);
}

TEST(Oscillation, IsASineThatGrowsFromWhereItBegins) {
  const Oscillation one{{2, 0, 0}, 0.5, 0.25, 1.0, 3.0};
  const double pi = 3.14159265358979323846;
  EXPECT_EQ(one.at(-1.0), Eigen::Vector3d::Zero());
  EXPECT_EQ(one.at(1.0), Eigen::Vector3d::Zero());
  EXPECT_NEAR(one.at(2.0).x(), 0.5 * 2 * std::sin(pi * 1.0 + 0.25), 1e-15) << "half grown";
  EXPECT_NEAR(one.at(4.5).x(), 2 * std::sin(pi * 3.5 + 0.25), 1e-14);
  const Oscillation at_once{{2, 0, 0}, 0.5, 0.0, 1.0, 1.0};
  EXPECT_NEAR(at_once.at(1.5).x(), 2.0, 1e-15);
}

TEST(Oscillation, LiesOnTopOfWhatElseChanges) {
  const Oscillation swings{{0, 3, 0}, 0.25, 0.0, 0.0, 0.0};
  const Gravity gravity{{0.0}, {{0, 0, -10}}, swings};
  EXPECT_LT((gravity.at(1.0) - Eigen::Vector3d(0, 3, -10)).norm(), 1e-14);
  EXPECT_EQ(gravity.scale(), 10.0);
  Motion motion;
  EXPECT_FALSE(motion.moves());
  motion.velocity = {1, 0, 0};
  motion.oscillation = swings;
  EXPECT_TRUE(motion.moves());
  EXPECT_LT((motion.at(1.0) - Eigen::Vector3d(1, 3, 0)).norm(), 1e-14);
  EXPECT_LT((motion.mean_velocity(0.0, 1.0) - Eigen::Vector3d(1, 3, 0)).norm(), 1e-14);
}

}  // namespace
}  // namespace stiction
