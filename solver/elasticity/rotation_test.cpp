// SPDX-License-Identifier: BSD-3-Clause
#include "solver/elasticity/rotation.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

Mat3 random_rotation(std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond q(normal(generator), normal(generator), normal(generator),
                             normal(generator));
  return q.normalized().toRotationMatrix();
}

// Q diag(stretches) Qᵀ with principal stretches of up to 1 ± `amount`.
Mat3 random_stretch(std::mt19937_64& generator, double amount) {
  std::uniform_real_distribution<double> uniform(1.0 - amount, 1.0 + amount);
  const Mat3 q = random_rotation(generator);
  return q * Vec3(uniform(generator), uniform(generator), uniform(generator)).asDiagonal() *
         q.transpose();
}

// The polynomial's terms reach φ⁴ = 81 beside a slope of 64 at F = R, and R sums terms of up to 48
// over D = 64: some ten roundings of ε each, in nine entries; stretches of 30 % double it.
constexpr double kRoundOff = 100.0 * test::kEpsilon;

class PolarRotation : public testing::TestWithParam<int> {};

TEST_P(PolarRotation, RecoversTheRotationOfAStretchedFrame) {
  std::mt19937_64 generator(1);
  for (int k = 0; k < 2000; ++k) {
    const Mat3 r = random_rotation(generator);
    const Mat3 f = r * random_stretch(generator, GetParam() / 100.0);
    ASSERT_LT((polar_rotation(f) - r).norm(), kRoundOff) << f;
  }
}

TEST_P(PolarRotation, AgreesWithSingularValuesAndIsOrthogonal) {
  std::mt19937_64 generator(2);
  for (int k = 0; k < 2000; ++k) {
    const Mat3 f = random_rotation(generator) * random_stretch(generator, GetParam() / 100.0);
    const Mat3 r = polar_rotation(f);
    ASSERT_LT((r - polar_rotation_by_svd(f)).norm(), kRoundOff) << f;
    ASSERT_LT((r.transpose() * r - Mat3::Identity()).norm(), kRoundOff) << f;
    ASSERT_GT(r.determinant(), 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Stretches, PolarRotation, testing::Values(0, 1, 3, 10, 30),
                         [](const auto& one) { return std::to_string(one.param) + "Percent"; });

TEST(PolarRotationOfAFrame, IsTheFrameItselfWhenNothingIsStretched) {
  EXPECT_LT((polar_rotation(Mat3::Identity()) - Mat3::Identity()).norm(), kRoundOff);
  const Mat3 upside_down = Eigen::AngleAxisd(std::numbers::pi, Vec3(1, 1, 0).normalized()).matrix();
  EXPECT_LT((polar_rotation(upside_down) - upside_down).norm(), kRoundOff);
}

TEST(PolarRotationOfAFlatFrame, IsARotationThatLeavesASymmetricStretch) {
  std::mt19937_64 generator(3);
  for (const double thickness : {0.02, 0.005, 1e-6, 0.0, -1e-6, -0.5, -0.8}) {
    for (int k = 0; k < 200; ++k) {
      const Mat3 q = random_rotation(generator);
      const Mat3 f =
          random_rotation(generator) * q * Vec3(1.1, 0.9, thickness).asDiagonal() * q.transpose();
      const Mat3 r = polar_rotation(f);
      // Above 1 % of the volume in closed form, where D has fallen to 4 · 2 · 0.9 · 1.1 · … ≈ 8 and
      // round-off grows as much; below it by singular values.
      ASSERT_LT((r.transpose() * r - Mat3::Identity()).norm(), 10.0 * kRoundOff) << thickness;
      ASSERT_GT(r.determinant(), 0.0) << thickness;
      const Mat3 s = r.transpose() * f;
      ASSERT_LT((s - s.transpose()).norm(), 10.0 * kRoundOff) << thickness;
      // The stretch that an inverted frame keeps is the smallest one, with its sign.
      ASSERT_NEAR(s.trace(), 2.0 + thickness, 10.0 * kRoundOff);
    }
  }
}

}  // namespace
}  // namespace stiction
