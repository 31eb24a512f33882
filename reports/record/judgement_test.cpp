// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/judgement.h"

#include <gtest/gtest.h>

#include <limits>

namespace stiction {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(CorrectDigits, CountFromTheScale) {
  EXPECT_DOUBLE_EQ(correct_digits(1e-3, 1.0), 3.0);
  EXPECT_DOUBLE_EQ(correct_digits(-1e-3, 1.0), 3.0);
  EXPECT_DOUBLE_EQ(correct_digits(1e-3, -10.0), 4.0);
}

TEST(CorrectDigits, LieBetweenZeroAndWhatADoubleHolds) {
  EXPECT_EQ(correct_digits(0.0, 1.0), 16.0);
  EXPECT_EQ(correct_digits(1e-30, 1.0), 16.0);
  EXPECT_EQ(correct_digits(7.0, 1.0), 0.0);
  EXPECT_EQ(correct_digits(kNaN, 1.0), 0.0);
  EXPECT_EQ(correct_digits(kInfinity, 1.0), 0.0);
}

TEST(ScaleOf, IsTheCasesOwnElseTheExpectedValueElseNothing) {
  EXPECT_EQ(scale_of({.expected = -2.0}), 2.0);
  EXPECT_EQ(scale_of({.expected = -2.0, .scale = 1.0}), 1.0);
  EXPECT_EQ(scale_of({.expected = 0.0, .scale = 5.0}), 5.0);
  EXPECT_EQ(scale_of({.expected = 0.0}), std::nullopt);
}

TEST(ShareOfTolerance, IsErrorOverTolerance) {
  EXPECT_EQ(share_of_tolerance(-1.0, 4.0), 0.25);
  EXPECT_EQ(share_of_tolerance(0.0, 0.0), 0.0) << "no error at tolerance 0 is no offence";
  EXPECT_EQ(share_of_tolerance(1e-300, 0.0), kInfinity);
  EXPECT_EQ(share_of_tolerance(kNaN, 1.0), kInfinity);
  EXPECT_EQ(share_of_tolerance(1.0, kNaN), kInfinity);
}

}  // namespace
}  // namespace stiction
