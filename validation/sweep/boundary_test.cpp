// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/sweep/boundary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "solver/testing/test_refusal.h"
#include "validation/user/test_user_problem.h"

namespace stiction {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kBoundary = R"(problem = "ramp.toml"
[[axis]]
vary = "ramp.friction"
values = [0.25, 0.5]
[[axis]]
vary = "ramp.slope_tan"
values = [0.2, 0.3, 0.4, 0.6]
[boundary]
along = "ramp.slope_tan"
expected = "ramp.friction"
tolerance = 0.06
reason = "half a step"
)";

class BoundaryOfAStudy : public test::UserProblem {
 protected:
  Study study(const std::string& from = "", const std::string& to = "") {
    write(edited("slope_deg = 20", "slope_tan = 0.1"));
    std::ofstream(folder_ / "study.toml") << test::replaced(kBoundary, from, to);
    return read_study(folder_ / "study.toml");
  }
  std::string refusal(const std::string& from, const std::string& to) {
    return test::refusal([&] { study(from, to); });
  }

  // '#' holds, '.' fails, '!' broke off, 'o' and '-' the same without a judge, '?' unknown.
  static Results results(const std::string& signs) {
    Results all;
    for (const char sign : signs) {
      PointResult one{sign != '?', Verdict::kFail, sign == '#' || sign == 'o', 0.5, {0.0}};
      if (sign == '#') one.verdict = Verdict::kPass;
      if (sign == '!') one.verdict = Verdict::kError;
      if (sign == 'o' || sign == '-') one.verdict = Verdict::kForInformation;
      all.push_back(one);
    }
    return all;
  }

  static Record record(const Study& study, const std::string& signs) {
    const std::vector<Record> all = boundary_records(study, Points(study), results(signs));
    if (all.size() != 1) throw std::logic_error("not one record");
    return all.front();
  }
};

TEST_F(BoundaryOfAStudy, IsRightWhereNoOutcomeIsWrong) {
  const Record one = record(study(), "#...###.");
  EXPECT_EQ(one.checks.front().value, 0.0);
  EXPECT_EQ(one.verdict, Verdict::kPass);
  EXPECT_EQ(one.case_name, "sweep/study/boundary");
  EXPECT_EQ(one.configuration, "quiet");
  ASSERT_EQ(one.series.size(), 2u);
  EXPECT_THAT(one.series[0].x, ElementsAre(0.25, 0.5));
  EXPECT_THAT(one.series[0].y, ElementsAre(0.2, 0.4)) << one.series[0].name;
  EXPECT_THAT(one.series[1].y, ElementsAre(0.3, 0.6)) << one.series[1].name;
  EXPECT_EQ(one.cost.cpu_seconds, 4.0);
}

TEST_F(BoundaryOfAStudy, IsJudgedByTheFarthestWrongOutcome) {
  const Record above = record(study(), "##..####");
  EXPECT_NEAR(above.checks.front().value, 0.1, 1e-15);
  EXPECT_EQ(above.verdict, Verdict::kFail);
  EXPECT_EQ(above.checks.front().worst, "ramp.friction = 0.5, ramp.slope_tan = 0.6 holds");
  const Record below = record(study(), "....#...");
  EXPECT_NEAR(below.checks.front().value, -0.2, 1e-15);
  EXPECT_THAT(below.notes, testing::Contains("3 of 8 outcomes are on the wrong side"));
  const Record within = record(study(), "##..###.");
  EXPECT_NEAR(within.checks.front().value, 0.05, 1e-15);
  EXPECT_EQ(within.verdict, Verdict::kPass);
}

TEST_F(BoundaryOfAStudy, FailsWhereAPointBrokeOff) {
  const Record one = record(study(), "!...###.");
  EXPECT_EQ(one.verdict, Verdict::kFail);
  EXPECT_TRUE(std::isnan(one.checks.front().value));
  EXPECT_EQ(one.checks.front().worst, "1 point broke off");
  EXPECT_EQ(record(study(), "!!!!!!!!").verdict, Verdict::kFail);
}

TEST_F(BoundaryOfAStudy, FailsWhereOneSideHasNoOutcome) {
  const Study far = study("expected = \"ramp.friction\"", "expected = 5");
  EXPECT_EQ(record(far, "########").checks.front().worst, "no point lies where it must fail");
  EXPECT_EQ(record(far, "########").verdict, Verdict::kFail);
  const Study near = study("expected = \"ramp.friction\"", "expected = 0.1");
  EXPECT_EQ(record(near, "........").checks.front().worst, "no point lies where it must hold");
}

TEST_F(BoundaryOfAStudy, OfAnEngineThatLacksWhatItNeedsIsNotApplicable) {
  Results lacking = results("........");
  for (PointResult& one : lacking) one.verdict = Verdict::kNotApplicable;
  const Study read = study();
  const std::vector<Record> all = boundary_records(read, Points(read), lacking);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all.front().verdict, Verdict::kNotApplicable);
  EXPECT_EQ(boundary_screen(all, {.width = 80}).find("nan"), std::string::npos);
}

TEST_F(BoundaryOfAStudy, AStepOfADecimalGridIsWithinAToleranceOfThatStep) {
  const Study read =
      study("expected = \"ramp.friction\"\ntolerance = 0.06", "expected = 0.3\ntolerance = 0.1");
  EXPECT_EQ(record(read, "#.#.#.#.").verdict, Verdict::kPass) << "0.4 - 0.3 is above 0.1 in binary";
}

TEST_F(BoundaryOfAStudy, OfWhatNobodyJudgesIsForInformation) {
  const Record one = record(study(), "oo--ooo-");
  EXPECT_EQ(one.verdict, Verdict::kForInformation);
  EXPECT_NEAR(one.checks.front().value, 0.05, 1e-15);
}

TEST_F(BoundaryOfAStudy, NeedsAllPoints) {
  const Study read = study();
  EXPECT_THAT(boundary_records(read, Points(read), results("#...###?")), IsEmpty());
}

TEST_F(BoundaryOfAStudy, CanBeANumberAboveWhichPointsHold) {
  const Study read = study("expected = \"ramp.friction\"", "expected = 0.35\nholds = \"above\"");
  EXPECT_EQ(record(read, "..##..##").checks.front().value, 0.0);
  EXPECT_NEAR(record(read, "..##.###").checks.front().value, -0.05, 1e-15);
}

TEST_F(BoundaryOfAStudy, HasNoWrongOutcomeOnItself) {
  const Study read = study("expected = \"ramp.friction\"", "expected = 0.3");
  EXPECT_EQ(record(read, "#...##..").checks.front().value, 0.0);
}

TEST_F(BoundaryOfAStudy, ThatIsNoneIsRefusedWithItsLine) {
  EXPECT_THAT(
      refusal("along = \"ramp.slope_tan\"", "along = \"ramp.slope\""),
      HasSubstr(":9: no axis varies 'ramp.slope'; there are: ramp.friction, ramp.slope_tan"));
  EXPECT_THAT(refusal("expected = \"ramp.friction\"", "expected = \"ramp.slope_tan\""),
              HasSubstr("another axis in the same unit"));
  EXPECT_THAT(refusal("tolerance = 0.06", "tolerance = -1"), HasSubstr("must not be negative"));
  EXPECT_THAT(refusal("tolerance = 0.06", "tolerance = 0.06\nholds = \"left\""),
              HasSubstr("\"below\" or \"above\""));
  EXPECT_THAT(refusal("reason = \"half a step\"", ""), HasSubstr("lacks 'reason'"));
}

}  // namespace
}  // namespace stiction
