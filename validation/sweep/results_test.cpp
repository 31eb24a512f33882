// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/sweep/results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "validation/user/test_user_problem.h"

namespace stiction {
namespace {

using testing::HasSubstr;
using testing::Not;

class SweepResults : public test::UserProblem {
 protected:
  void SetUp() override {
    UserProblem::SetUp();
    write(test::kProblem);
    std::ofstream(folder_ / "study.toml") << R"(problem = "ramp.toml"
[[axis]]
vary = "ramp.friction"
values = [0.25, 0.5, 0.75]
[[axis]]
vary = "ramp.slope_deg"
values = [10, 20]
)";
    study_ = read_study(folder_ / "study.toml");
    // Column by column, upwards.
    for (const Verdict verdict : {Verdict::kPass, Verdict::kFail, Verdict::kPass, Verdict::kError,
                                  Verdict::kPass, Verdict::kNotApplicable}) {
      results_.push_back({true, verdict, verdict == Verdict::kPass, 0.5, {-1.5}});
    }
  }

  Study study_;
  Results results_;
};

TEST_F(SweepResults, TheDiagramHasTheFirstAxisAcrossAndTheSecondUp) {
  const std::string text = results_screen(study_, results_, {.width = 80});
  EXPECT_THAT(text, HasSubstr("  20 .! \n  10 ###\n"));
  EXPECT_THAT(text, HasSubstr("ramp.slope_deg [°] up, ramp.friction across"));
}

TEST_F(SweepResults, CountsThatAreAllZeroHaveNoColumn) {
  const std::string text = results_screen(study_, results_, {.width = 80});
  EXPECT_THAT(text, HasSubstr("broke off"));
  EXPECT_THAT(text, HasSubstr("not applicable"));
  EXPECT_THAT(text, Not(HasSubstr("missing  CPU")));
  results_.back().known = false;
  EXPECT_THAT(results_screen(study_, results_, {.width = 80}), HasSubstr("missing  CPU"));
}

TEST_F(SweepResults, WhatNobodyJudgesIsNoFailure) {
  results_[1].verdict = Verdict::kForInformation;
  const std::string text = results_screen(study_, results_, {.width = 80});
  EXPECT_THAT(text, HasSubstr("  20 -! \n  10 ###\n"));
  EXPECT_THAT(text, HasSubstr("not judged"));
  results_[1].holds = true;
  EXPECT_THAT(results_screen(study_, results_, {.width = 80}), HasSubstr("  20 o! \n  10 ###\n"));
}

TEST_F(SweepResults, ATerminalThatIsTooNarrowHasNoDiagram) {
  EXPECT_THAT(results_screen(study_, results_, {.width = 8}), Not(HasSubstr("across")));
}

TEST_F(SweepResults, TheTableHasALineAPointAndEmptyCellsOfUnknownOnes) {
  results_[1].known = false;
  results_[1].values.clear();
  const Points points(study_);
  const std::string table = points_csv(study_, points, {0, 1}, results_);
  EXPECT_THAT(table, HasSubstr("point,case,engine,configuration,ramp.friction,ramp.slope_deg [°],"
                               "verdict,cpu_seconds,check 1\r\n"));
  EXPECT_THAT(table, HasSubstr(points.hash(0) +
                               ",user/ramp/ramp.friction=0.25/ramp.slope_deg=10,stiction,,0.25,10,"
                               "pass,0.5,-1.5\r\n"));
  EXPECT_THAT(table, HasSubstr(",0.25,20,,,\r\n"));
  EXPECT_THAT(table, Not(HasSubstr(",0.5,10,"))) << "another shard's";
}

}  // namespace
}  // namespace stiction
