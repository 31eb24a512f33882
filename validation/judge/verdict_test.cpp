// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/judge/verdict.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace stiction {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Judge, PassesUpToTheToleranceItself) {
  EXPECT_EQ(judge({.expected = 1.0, .tolerance = 0.5}, 1.5).verdict, Verdict::kPass);
  EXPECT_EQ(judge({.expected = 1.0, .tolerance = 0.5}, 0.5).verdict, Verdict::kPass);
  EXPECT_EQ(judge({.expected = 1.0, .tolerance = 0.4999}, 1.5).verdict, Verdict::kFail);
  EXPECT_EQ(judge({.expected = 1.0, .tolerance = 0.4999}, 0.5).verdict, Verdict::kFail);
}

TEST(Judge, FillsInErrorAndDigits) {
  const Judgement check = judge({.expected = 2.0, .tolerance = 1.0}, 2.002);
  EXPECT_NEAR(check.error, 2e-3, 1e-15);
  EXPECT_NEAR(check.digits.value(), 3.0, 1e-9);
  EXPECT_NEAR(check.of_tolerance, 2e-3, 1e-15);
  EXPECT_EQ(check.claim.scale, std::nullopt) << "the record shows the case's own";
}

TEST(Judge, RelatesErrorAndToleranceToTheExpectedValue) {
  const Judgement check = judge({.expected = -200.0, .relative = true, .tolerance = 0.01}, -202.0);
  EXPECT_DOUBLE_EQ(check.error, -0.01);
  EXPECT_EQ(check.verdict, Verdict::kPass);
  EXPECT_EQ(judge({.expected = -200.0, .relative = true, .tolerance = 0.0099}, -202.0).verdict,
            Verdict::kFail);
}

TEST(Judge, RelatesToAScaleThatTheCaseGives) {
  const Judgement check =
      judge({.expected = 0.0, .relative = true, .scale = 10.0, .tolerance = 1e-4}, 1e-3);
  EXPECT_DOUBLE_EQ(check.error, 1e-4);
  EXPECT_EQ(check.verdict, Verdict::kPass);
  EXPECT_DOUBLE_EQ(check.digits.value(), 4.0);
}

TEST(Judge, GivesNoDigitsWhereZeroIsExpectedOfNoScale) {
  const Judgement check = judge({.expected = 0.0, .tolerance = 1e-4}, 1e-5);
  EXPECT_EQ(check.digits, std::nullopt);
  EXPECT_NEAR(check.of_tolerance, 0.1, 1e-15);
}

TEST(Judge, TakesAScaleOfOneUnitAtItsWord) {
  const Judgement check = judge({.expected = 20.0, .scale = 1.0, .tolerance = 1.0}, 20.01);
  EXPECT_NEAR(check.digits.value(), 2.0, 1e-9);
}

TEST(Judge, FailsWhatIsNoNumber) {
  EXPECT_EQ(judge({.expected = 1.0, .tolerance = kInfinity}, kNaN).verdict, Verdict::kFail);
  EXPECT_EQ(judge({.expected = kNaN, .tolerance = 1.0}, 1.0).verdict, Verdict::kFail);
  EXPECT_EQ(judge({.expected = 1.0, .tolerance = kNaN}, 1.0).verdict, Verdict::kFail);
}

// A slip that shall vanish and is expected from 1e-6 to 9e-6 m/s.
Verdict banded(double slip, Verdict in_band = Verdict::kShortfall) {
  return judge({.expected = 0.0, .tolerance = 1e-9}, slip, 1.0,
               KnownShortfall{Band{1e-6, 9e-6}, in_band, "a cause"})
      .verdict;
}

TEST(Judge, GivesABandsVerdictInsideItEndsIncluded) {
  for (const double slip : {1e-6, 3e-6, 9e-6}) {
    EXPECT_EQ(banded(slip), Verdict::kShortfall);
    EXPECT_EQ(banded(slip, Verdict::kRefuted), Verdict::kRefuted);
  }
}

TEST(Judge, FailsOutsideABandOnBothSides) {
  EXPECT_EQ(banded(3.0), Verdict::kFail) << "a million times worse than known";
  EXPECT_EQ(banded(9.1e-6), Verdict::kFail);
  EXPECT_EQ(banded(9e-7), Verdict::kFail) << "better than known";
  EXPECT_EQ(banded(-3e-6), Verdict::kFail) << "on the other side of the claim";
  EXPECT_EQ(banded(1e-10), Verdict::kFail) << "the claim holds: the band has to go";
  EXPECT_EQ(banded(0.0), Verdict::kFail);
}

TEST(Judge, FailsWhatHoldsInsideABand) {
  EXPECT_EQ(
      judge({.expected = 1.0, .tolerance = 0.5}, 1.0, 1.0, KnownShortfall{Band{0.0, 2.0}}).verdict,
      Verdict::kFail);
}

TEST(Judge, KeepsBandAndCause) {
  const Judgement check = judge({.expected = 0.0, .tolerance = 1e-9}, 3e-6, 1.0,
                                KnownShortfall{Band{1e-6, 9e-6}, Verdict::kRefuted, "a cause"});
  ASSERT_TRUE(check.band.has_value());
  EXPECT_EQ(check.band->high, 9e-6);
  EXPECT_EQ(check.cause, "a cause");
}

TEST(Judge, AdmitsInfinityOnlyWhereABandNamesIt) {
  EXPECT_EQ(banded(kInfinity), Verdict::kFail);
  const Claim claim{.expected = 0.0, .tolerance = 1.0};
  const KnownShortfall diverges{Band{1e3, kInfinity}};
  EXPECT_EQ(judge(claim, kInfinity, 1.0, diverges).verdict, Verdict::kShortfall)
      << "it diverges, as expected";
  EXPECT_EQ(judge(claim, kNaN, 1.0, diverges).verdict, Verdict::kFail)
      << "what could not be measured is expected nowhere";
}

TEST(Judge, DemandsThatABandsVerdictIsOneOfTheTwo) {
  EXPECT_THROW(banded(3e-6, Verdict::kPass), std::logic_error);
}

TEST(Judge, WithToleranceScaleZeroFailsAllButWhatIsExact) {
  EXPECT_EQ(judge({.expected = 1.0, .tolerance = 0.5}, 1.0, 0.0).verdict, Verdict::kPass);
  EXPECT_EQ(judge({.expected = 1.0, .tolerance = 0.5}, 1.0 + 1e-15, 0.0).verdict, Verdict::kFail);
}

TEST(Judge, MultipliesTheTolerance) {
  const Claim claim{.expected = 1.0, .tolerance = 0.5};
  EXPECT_EQ(judge(claim, 2.0, 1.9).verdict, Verdict::kFail);
  EXPECT_EQ(judge(claim, 2.0, 2.0).verdict, Verdict::kPass);
  EXPECT_EQ(judge(claim, 2.0, 2.0).claim.tolerance, 0.5) << "the record shows the case's own";
}

TEST(ForInformation, HasTheNumbersAndDecidesNothing) {
  const Judgement check = for_information({.expected = 4.0}, 5.0);
  EXPECT_EQ(check.verdict, Verdict::kForInformation);
  EXPECT_EQ(check.error, 1.0);
}

TEST(Judge, DemandsAScale) {
  EXPECT_THROW(judge({.expected = 0.0, .scale = 0.0}, 1.0), std::logic_error);
  EXPECT_THROW(judge({.expected = 0.0, .relative = true}, 1.0), std::logic_error);
}

}  // namespace
}  // namespace stiction
