// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/estimate/threshold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

// As the acceleration of what slides tells it.
Holding by_line(double x) { return {holds_below(x), x - kCritical}; }

TEST(FindThresholdNear, GoesWhereTheExcessLeads) {
  for (const double guess : {0.1, 0.3, 0.4, 0.9}) {
    for (const double width : {1e-4, 1e-9}) {
      const Bracket near = find_threshold_near(guess, 0.01, 1.0, width, by_line);
      EXPECT_TRUE(near.contains(kCritical)) << guess;
      EXPECT_LE(near.width(), width) << guess;
      EXPECT_LE(near.evaluations, 8) << guess << " " << width;
    }
  }
  const auto above = [](double x) { return Holding(x >= kCritical, kCritical - x); };
  const Bracket down = find_threshold_near(0.3, -0.01, 1.0, 1e-9, above);
  EXPECT_TRUE(down.contains(kCritical));
  EXPECT_LE(down.evaluations, 4) << "two that fail, and one on either side of where they lead";
}

// What rests tells only that it does: of its excess no more is known than that it is below 0.
TEST(FindThresholdNear, NeedsFewerRunsWhereTheorySaysHowSteepTheExcessIs) {
  const auto at_rest = [](double x) {
    return Holding(holds_below(x), std::max(-1e-3, x - kCritical));
  };
  for (const double guess : {0.2, 0.3332, 0.3334, 0.4}) {
    const Bracket near = find_threshold_near(guess, 0.1, 1.0, 1e-9, at_rest, 1.0);
    EXPECT_TRUE(near.contains(kCritical)) << guess;
    EXPECT_LE(near.width(), 1e-9) << guess;
    EXPECT_LE(near.evaluations, guess < kCritical ? 5 : 3) << guess;
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double wrong : {-1.0, 0.0, 1e-9, 1e9, 0.3, kInfinity, Holding::kUnknown}) {
    const Bracket near = find_threshold_near(0.4, 0.1, 1.0, 1e-9, at_rest, wrong);
    EXPECT_TRUE(near.contains(kCritical)) << wrong;
    EXPECT_LE(near.width(), 1e-9) << wrong;
    EXPECT_LE(near.evaluations, 12) << wrong;
  }
}

TEST(FindThreshold, ExcessThatBendsStillLeadsThere) {
  for (const double power : {0.5, 2.0, 3.0}) {
    const Bracket bracket = find_threshold(0.0, 1.0, 1e-9, [&](double x) {
      return Holding(holds_below(x), std::pow(std::max(0.0, x - kCritical), power));
    });
    EXPECT_TRUE(bracket.contains(kCritical)) << power;
    EXPECT_LE(bracket.width(), 1e-9) << power;
    EXPECT_LT(bracket.evaluations, 2 * 32) << "no more than twice what bisection takes";
  }
}

// What is told is no excess at all, and may not even be a number: runs are lost, and nothing else.
TEST(FindThreshold, ALyingExcessOnlyCostsRuns) {
  const double nonsense[] = {1.0, 1e-300, 1e300, INFINITY, -1.0, 0.0, NAN, 0.3, 0.3, 7.0, 2e-9};
  for (int first = 0; first < 11; ++first) {
    int calls = first;
    const auto lie = [&](double x) { return Holding(holds_below(x), nonsense[calls++ % 11]); };
    const Bracket bracket = find_threshold(0.0, 1.0, 1e-9, lie);
    EXPECT_TRUE(bracket.contains(kCritical)) << first;
    EXPECT_TRUE(holds_below(bracket.holds) && !holds_below(bracket.fails)) << first;
    EXPECT_LE(bracket.width(), 1e-9) << first;
    EXPECT_LT(bracket.evaluations, 2 * 32) << first;
    EXPECT_EQ(bracket.evaluations, calls - first);
    calls = first;
    const Bracket near = find_threshold_near(0.9, 1e-6, 1.0, 1e-9, lie);
    EXPECT_TRUE(near.contains(kCritical)) << first;
    EXPECT_LE(near.width(), 1e-9) << first;
  }
}

TEST(Narrow, GoesOnWithWhatTheSearchBeforeItKnew) {
  const Bracket coarse = find_threshold_near(0.5, 0.1, 1.0, 0.2, by_line);
  const Bracket fine = narrow(coarse, 1e-9, by_line);
  EXPECT_TRUE(fine.contains(kCritical));
  EXPECT_LE(fine.width(), 1e-9);
  EXPECT_LE(fine.evaluations, coarse.evaluations + 3);
}

}  // namespace
}  // namespace stiction
