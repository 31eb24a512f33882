// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/estimate/threshold.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stiction {
namespace {

const double kCritical = 1.0 / 3.0;

bool holds_below(double x) { return x <= kCritical; }

TEST(FindThreshold, BracketsAKnownValueWithinTheWidth) {
  const Bracket bracket = find_threshold(0.0, 1.0, 1e-9, holds_below);
  EXPECT_LE(bracket.width(), 1e-9);
  EXPECT_GT(bracket.width(), 1e-9 / 2.1) << "and no narrower than asked for";
  EXPECT_TRUE(holds_below(bracket.holds));
  EXPECT_FALSE(holds_below(bracket.fails));
  EXPECT_TRUE(bracket.contains(kCritical));
  EXPECT_NEAR(bracket.middle(), kCritical, 0.5e-9);
}

TEST(FindThreshold, CountsItsEvaluations) {
  int calls = 0;
  const Bracket bracket = find_threshold(0.0, 1.0, 0.1, [&](double x) {
    ++calls;
    return holds_below(x);
  });
  EXPECT_EQ(calls, 2 + 4);  // both ends, and 1 → 1/16
  EXPECT_EQ(bracket.evaluations, calls);
}

TEST(FindThreshold, SearchesDownwardsAsWell) {
  const Bracket bracket = find_threshold(1.0, 0.0, 1e-6, [](double x) { return x >= kCritical; });
  EXPECT_GT(bracket.holds, bracket.fails);
  EXPECT_TRUE(bracket.contains(kCritical));
  EXPECT_LE(bracket.width(), 1e-6);
}

TEST(FindThreshold, GivesNaNWhenAnEndIsNotWhatItShouldBe) {
  for (const bool always : {true, false}) {
    const Bracket bracket = find_threshold(0.0, 1.0, 1e-6, [&](double) { return always; });
    EXPECT_TRUE(std::isnan(bracket.holds)) << always;
    EXPECT_TRUE(std::isnan(bracket.fails)) << always;
    EXPECT_TRUE(std::isnan(bracket.middle())) << always;
    EXPECT_FALSE(bracket.contains(kCritical)) << always;
    EXPECT_EQ(bracket.evaluations, always ? 2 : 1);
  }
}

TEST(Bracket, ContainsItsEnds) {
  const Bracket bracket{2.0, 1.0, 0};
  EXPECT_TRUE(bracket.contains(1.0));
  EXPECT_TRUE(bracket.contains(2.0));
  EXPECT_FALSE(bracket.contains(0.999));
  EXPECT_FALSE(bracket.contains(2.001));
  EXPECT_FALSE(bracket.contains(std::nan("")));
}

TEST(FindThresholdNear, FindsWhatTheWholeIntervalDoesInFewerRuns) {
  const Bracket whole = find_threshold(0.0, 1.0, 1e-9, holds_below);
  const Bracket near = find_threshold_near(kCritical + 3e-9, 4e-9, 0.5, 1e-9, holds_below);
  EXPECT_TRUE(near.contains(kCritical));
  EXPECT_LE(near.width(), 1e-9);
  EXPECT_LT(near.evaluations, 6);
  EXPECT_GT(whole.evaluations, 30);
}

TEST(FindThresholdNear, AWrongGuessOnEitherSideOnlyCostsRuns) {
  for (const double guess : {0.01, 0.2, 0.4, 0.9}) {
    int calls = 0;
    const Bracket near = find_threshold_near(guess, 1e-6, 1.0, 1e-7, [&](double x) {
      ++calls;
      return holds_below(x);
    });
    EXPECT_TRUE(near.contains(kCritical)) << guess;
    EXPECT_TRUE(holds_below(near.holds)) << guess;
    EXPECT_FALSE(holds_below(near.fails)) << guess;
    EXPECT_LE(near.width(), 1e-7) << guess;
    EXPECT_EQ(near.evaluations, calls) << guess;
  }
}

TEST(FindThresholdNear, SearchesDownwardsAsWell) {
  const auto holds_above = [](double x) { return x >= kCritical; };
  for (const double guess : {0.3, 0.4}) {
    const Bracket near = find_threshold_near(guess, -1e-3, 0.5, 1e-6, holds_above);
    EXPECT_GT(near.holds, near.fails) << guess;
    EXPECT_TRUE(near.contains(kCritical)) << guess;
  }
}

TEST(FindThresholdNear, GivesUpWithNoNumberBeyondItsReach) {
  for (const bool always : {true, false}) {
    const Bracket near = find_threshold_near(0.5, 0.01, 0.3, 1e-6, [&](double) { return always; });
    EXPECT_TRUE(std::isnan(near.holds) && std::isnan(near.fails)) << always;
    EXPECT_EQ(near.evaluations, 5) << always;  // the guess, 0.01, 0.05, 0.21 and 0.3 off it
  }
}

}  // namespace
}  // namespace stiction
