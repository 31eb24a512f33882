// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/judge/verdict.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace stiction {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Check judged(Check check, double tolerance_scale = 1.0) {
  check.error = kNaN;  // to be filled in
  check.digits = kNaN;
  judge(check, tolerance_scale);
  return check;
}

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

TEST(Judge, PassesUpToTheToleranceItself) {
  EXPECT_EQ(judged({.value = 1.5, .expected = 1.0, .tolerance = 0.5}).verdict, Verdict::kPass);
  EXPECT_EQ(judged({.value = 0.5, .expected = 1.0, .tolerance = 0.5}).verdict, Verdict::kPass);
  EXPECT_EQ(judged({.value = 1.5, .expected = 1.0, .tolerance = 0.4999}).verdict, Verdict::kFail);
  EXPECT_EQ(judged({.value = 0.5, .expected = 1.0, .tolerance = 0.4999}).verdict, Verdict::kFail);
}

TEST(Judge, FillsInErrorAndDigits) {
  const Check check = judged({.value = 2.002, .expected = 2.0, .tolerance = 1.0});
  EXPECT_NEAR(check.error, 2e-3, 1e-15);
  EXPECT_NEAR(check.digits, 3.0, 1e-9);
  EXPECT_EQ(check.scale, 2.0);
}

TEST(Judge, RelatesErrorAndToleranceToTheExpectedValue) {
  const Check check =
      judged({.value = -202.0, .expected = -200.0, .relative = true, .tolerance = 0.01});
  EXPECT_DOUBLE_EQ(check.error, -0.01);
  EXPECT_EQ(check.verdict, Verdict::kPass);
  EXPECT_EQ(
      judged({.value = -202.0, .expected = -200.0, .relative = true, .tolerance = 0.0099}).verdict,
      Verdict::kFail);
}

TEST(Judge, RelatesToAScaleThatTheCaseGives) {
  const Check check =
      judged({.value = 1e-3, .expected = 0.0, .relative = true, .scale = 10.0, .tolerance = 1e-4});
  EXPECT_DOUBLE_EQ(check.error, 1e-4);
  EXPECT_EQ(check.verdict, Verdict::kPass);
  EXPECT_DOUBLE_EQ(check.digits, 4.0);
}

TEST(Judge, CountsDigitsOfAZeroFromOneUnit) {
  EXPECT_DOUBLE_EQ(judged({.value = 1e-5, .expected = 0.0}).digits, 5.0);
}

TEST(Judge, FailsWhatIsNoNumber) {
  EXPECT_EQ(judged({.value = kNaN, .expected = 1.0, .tolerance = kInfinity}).verdict,
            Verdict::kFail);
  EXPECT_EQ(judged({.value = 1.0, .expected = kNaN, .tolerance = 1.0}).verdict, Verdict::kFail);
  EXPECT_EQ(judged({.value = 1.0, .expected = 1.0, .tolerance = kNaN}).verdict, Verdict::kFail);
}

// A slip that shall vanish and is expected from 1e-6 to 9e-6 m/s.
Verdict banded(double slip, Verdict in_band = Verdict::kLimit) {
  Check check{.value = slip, .expected = 0.0, .tolerance = 1e-9, .band = Band{1e-6, 9e-6}};
  judge(check, 1.0, in_band);
  return check.verdict;
}

TEST(Judge, GivesABandsVerdictInsideItEndsIncluded) {
  for (const double slip : {1e-6, 3e-6, 9e-6}) {
    EXPECT_EQ(banded(slip), Verdict::kLimit);
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
  Check check{.value = 1.0, .expected = 1.0, .tolerance = 0.5, .band = Band{0.0, 2.0}};
  judge(check, 1.0);
  EXPECT_EQ(check.verdict, Verdict::kFail);
}

TEST(Judge, AdmitsInfinityOnlyWhereABandNamesIt) {
  EXPECT_EQ(banded(kInfinity), Verdict::kFail);
  Check check{.value = kInfinity, .expected = 0.0, .tolerance = 1.0, .band = Band{1e3, kInfinity}};
  judge(check, 1.0);
  EXPECT_EQ(check.verdict, Verdict::kLimit) << "it diverges, as expected";
  check.value = kNaN;
  check.verdict = Verdict::kFail;
  judge(check, 1.0);
  EXPECT_EQ(check.verdict, Verdict::kFail) << "what could not be measured is expected nowhere";
}

TEST(Judge, DemandsThatABandsVerdictIsOneOfTheTwo) {
  EXPECT_THROW(banded(3e-6, Verdict::kPass), std::logic_error);
}

TEST(Judge, WithToleranceScaleZeroFailsAllButWhatIsExact) {
  EXPECT_EQ(judged({.value = 1.0, .expected = 1.0, .tolerance = 0.5}, 0.0).verdict, Verdict::kPass);
  EXPECT_EQ(judged({.value = 1.0 + 1e-15, .expected = 1.0, .tolerance = 0.5}, 0.0).verdict,
            Verdict::kFail);
}

TEST(Judge, MultipliesTheTolerance) {
  const Check check{.value = 2.0, .expected = 1.0, .tolerance = 0.5};
  EXPECT_EQ(judged(check, 1.9).verdict, Verdict::kFail);
  EXPECT_EQ(judged(check, 2.0).verdict, Verdict::kPass);
  EXPECT_EQ(judged(check, 2.0).tolerance, 0.5) << "the record shows the case's own";
}

TEST(Judge, LeavesTheVerdictOfWhatIsOnlyShown) {
  for (const Verdict verdict : {Verdict::kShown, Verdict::kNotApplicable}) {
    const Check check = judged({.value = 5.0, .expected = 4.0, .verdict = verdict});
    EXPECT_EQ(check.verdict, verdict);
    EXPECT_EQ(check.error, 1.0);
  }
}

TEST(Judge, DemandsAScale) {
  EXPECT_THROW(judged({.value = 1.0, .expected = 0.0, .scale = 0.0}), std::logic_error);
}

}  // namespace
}  // namespace stiction
