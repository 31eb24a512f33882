// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/work_precision.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "reports/record/test_records.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// A run of a question with Δt in its name, at a cost (s/s) and an error.
Record run_of(const std::string& question, const std::string& dt, double seconds, double error,
              double doubt = 0.0) {
  Record one;
  one.case_name = fmt::format("{}{}/cells=2/dt={}", kWorkPrecision, question, dt);
  one.configuration = "quiet";
  one.figures = {{kErrorAtMost, "1", "", error},
                 {kErrorDoubt, "1", "", doubt},
                 {kWorkTime, "s/s", "", seconds},
                 {kWorkSpread, "1", "", 1.25}};
  one.verdict = Verdict::kForInformation;
  return one;
}

Record broken_run(const std::string& question, const std::string& dt, double seconds,
                  double error) {
  Record one = run_of(question, dt, seconds, error);
  one.failures = {{.reason = "it did not hold"}};
  return one;
}

std::vector<std::string> steps_of(const std::vector<WorkPoint>& points) {
  std::vector<std::string> steps;
  for (const WorkPoint& one : points) steps.push_back(one.parameters.at(1).second);
  return steps;
}

std::vector<WorkPoint> points_of(const std::vector<Record>& records) {
  return work_points(records).at(0);
}

TEST(WorkPrecision, TheFrontHasWhatNothingElseBeatsInBoth) {
  const std::vector<WorkPoint> points = points_of({
      run_of("stop", "1e-4", 0.2, 1e-4),
      run_of("stop", "2e-4", 0.1, 1e-3),
      run_of("stop", "3e-4", 0.3, 1e-4),   // dearer, as precise
      run_of("stop", "4e-4", 0.15, 2e-3),  // dearer, less precise
      run_of("stop", "5e-4", 0.1, 2e-3),   // as cheap, less precise
      run_of("stop", "1e-5", 2.0, 1e-7),
  });
  EXPECT_THAT(steps_of(work_front(points)), ElementsAre("2e-4", "1e-4", "1e-5"));
}

TEST(WorkPrecision, WhatBrokeIsNeverOnTheFrontHoweverCheapAndPrecise) {
  const double nan = test::kNan;
  Record error = run_of("stop", "6e-4", 0.01, 1e-12);
  error.verdict = Verdict::kError;
  error.error = "a body left the scene";
  const std::vector<WorkPoint> points = points_of({
      broken_run("stop", "1e-3", 0.001, 1e-12),
      error,
      run_of("stop", "5e-4", 0.01, nan),
      run_of("stop", "7e-4", 0.01, test::kInf),
      run_of("stop", "1e-4", 0.2, 1e-4),
  });
  EXPECT_THAT(steps_of(work_front(points)), ElementsAre("1e-4"));
  EXPECT_EQ(points.at(0).broken, "it did not hold");
  EXPECT_EQ(points.at(1).broken, "a body left the scene");
  EXPECT_EQ(points.at(2).broken, "there is no answer");
  EXPECT_FALSE(cheapest_setting(points, 1e-6).has_value());
}

TEST(WorkPrecision, TheCheapestSettingHasTheErrorAskedForOrLess) {
  const std::vector<WorkPoint> points =
      points_of({run_of("stop", "2e-4", 0.1, 1e-3), run_of("stop", "1e-4", 0.2, 1.01e-6),
                 run_of("stop", "5e-5", 0.4, 1e-6), run_of("stop", "1e-5", 2.0, 1e-7)});
  EXPECT_EQ(cheapest_setting(points, 1e-3)->seconds, 0.1);
  EXPECT_EQ(cheapest_setting(points, 1e-6)->seconds, 0.4);
  EXPECT_FALSE(cheapest_setting(points, 1e-9).has_value());
}

TEST(WorkPrecision, TheTableMergesPrecisionsAndSaysNoneWithTheBest) {
  Record one_sweep = run_of("creep", "1e-4", 0.05, 2e-13, 1.9e-13);
  one_sweep.settings["sweeps"] = "8";
  const Cells rows = cheapest_settings(
      {run_of("stop", "2e-4", 0.1, 5e-4), run_of("stop", "1e-5", 2.0, 1.2e-5, 1e-6), one_sweep});
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_THAT(rows[0],
              ElementsAre("question", "error ≤", "method", "cells", "dt", "CPU s/s", "error"));
  EXPECT_THAT(rows[1],
              ElementsAre("creep", "1e-3…1e-9", "quiet ×8", "2", "1e-4", "0.05", "≤ 2e-13"));
  EXPECT_THAT(rows[2], ElementsAre("stop", "1e-3", "quiet", "2", "2e-4", "0.1", "5e-04"));
  EXPECT_THAT(rows[3], ElementsAre("", "1e-6 none, best", "quiet", "2", "1e-5", "2", "1e-05"));
}

TEST(WorkPrecision, TheBestIsTheCheapestThatIsNotToldFromTheMostPrecise) {
  const std::vector<Record> records{run_of("stop", "4e-4", 0.1, 3.2e-5, 1e-5),
                                    run_of("stop", "2e-4", 0.2, 2.9e-5, 1e-5),
                                    run_of("stop", "1e-4", 0.4, 2e-5, 1e-5)};
  EXPECT_EQ(most_precise_setting(points_of(records))->seconds, 0.2);
  EXPECT_FALSE(
      most_precise_setting(points_of({broken_run("stop", "1e-3", 0.1, 1e-9)})).has_value());
}

TEST(WorkPrecision, MethodsAreAsCheapWhereCostsDifferByNoMoreThanRepetitionsDo) {
  const auto of = [](const char* method, double seconds, double error) {
    Record one = run_of("stop", "1e-4", seconds, error);
    one.configuration = method;
    return one;
  };
  Record broken = of("broken", 0.1, 1e-8);
  broken.failures = {{.reason = "it did not hold"}};
  const std::vector<WorkPoint> points =
      points_of({of("quiet", 0.1, 1e-7), of("paper", 0.124, 1e-7), of("secant", 0.126, 1e-7),
                 of("old", 0.1, 1e-5), broken});  // repetitions differ by 1.25
  EXPECT_THAT(as_cheap(points, points[0], 1e-6), ElementsAre("paper"));
  EXPECT_THAT(as_cheap(points, points[0], 1e-5), ElementsAre("old", "paper"));
}

TEST(WorkPrecision, AQuestionOfWhichAllRunsBrokeSaysSo) {
  const Cells rows = cheapest_settings({broken_run("stop", "2e-4", 0.1, 5e-4)});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_THAT(rows[1], ElementsAre("stop", "", "all broke", "", "", "", ""));
  EXPECT_TRUE(cheapest_settings({test::passing_record("incline/rest")}).empty());
  EXPECT_EQ(cheapest_settings_screen({test::passing_record("incline/rest")}, {}), "");
}

TEST(WorkPrecision, TheScreenCountsWhatBrokeAndTellsTheSpreadOfCosts) {
  Record broken = broken_run("stop", "1e-3", 0.001, 1e-12);
  broken.figures[3].value = 99.0;
  const std::vector<Record> records{run_of("stop", "2e-4", 0.1, 5e-4), broken};
  const std::string text = cheapest_settings_screen(records, {.width = 80});
  EXPECT_THAT(text, HasSubstr("Broke, and on no front: stop 1 of 2."));
  EXPECT_THAT(text, HasSubstr("differ by up to × 1.2"));
  EXPECT_THAT(text, Not(HasSubstr("1e-12")));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(display_width(line), 80u) << line;
}

TEST(WorkPrecision, MarkdownHasTheTableAndTheFrontOfEachQuestion) {
  const std::string text = work_precision_markdown(
      {run_of("stop", "2e-4", 0.1, 5e-4, 1e-5), broken_run("stop", "1e-3", 0.001, 1e-12)});
  EXPECT_THAT(text, HasSubstr("| stop | 1e-3 | quiet | 2 | 2e-4 | 0.1 | 5e-04 |  |\n"));
  EXPECT_THAT(text, HasSubstr("### Front of stop: 1 of 2 runs broke\n"));
  EXPECT_THAT(text, HasSubstr("| quiet | 2 | 2e-4 | 0.1 | 1.2 | 0.0005 | 1e-05 |\n"));
  EXPECT_THAT(text, Not(HasSubstr("1e-12")));
}

}  // namespace
}  // namespace stiction
