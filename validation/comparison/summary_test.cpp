// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "reports/formats/work_precision.h"
#include "reports/text/text.h"
#include "solver/testing/test_scenes.h"
#include "validation/comparison/comparison.h"

namespace stiction {
namespace {

using testing::HasSubstr;
using testing::Not;

Record record(const std::string& name, const std::string& rule, const std::string& method,
              double steps, double creep) {
  Record one;
  one.case_name = name;
  one.engine = "stiction";
  one.settings = {{"method", method}, {"rule", rule}};
  one.figures = {{kStepsTo9, "1", "", steps}, {kCreep, "m/s", "", creep}};
  return one;
}

std::vector<Record> two_scenes() {
  return {record("rules/a", "fixed-point", "paper", test::kInfinity, 2e-5),
          record("rules/a", "stored-vector", "quiet", 7, 1e-10),
          record("rules/a", "conjugate-vector", "quiet", 3, 1e-12),
          record("rules/a", "secant", "quiet", test::kInfinity, 1e-30),
          record("rules/a", "none", "quiet", test::kInfinity, 1e-3),
          record("rules/b", "fixed-point", "paper", test::kInfinity, 3e-5),
          record("rules/b", "stored-vector", "quiet", 9, 1e-9),
          record("rules/b", "conjugate-vector", "quiet", 4, 1e-11),
          record("rules/b", "secant", "quiet", test::kInfinity, 1e-30),
          record("rules/b", "none", "quiet", test::kInfinity, 1e-3)};
}

TEST(ComparisonSummary, NamesTheWinnerWithItsFigureBesideThePapers) {
  const std::vector<Placing> placed = placings(two_scenes(), 1);
  ASSERT_EQ(placed.size(), 2u);
  EXPECT_EQ(placed[0].rule, "secant");
  EXPECT_EQ(placed[0].figure, "1e-30 m/s");
  EXPECT_EQ(placed[1].rule, "conjugate-vector");
  EXPECT_EQ(placed[1].contacts, "quiet");
  EXPECT_EQ(placed[1].figure, "2 of 2 in 4");
  EXPECT_EQ(placed[1].paper, "never");
  EXPECT_EQ(placed[1].cost, "–");
}

TEST(ComparisonSummary, NeverLetsOneThatFailedWin) {
  std::vector<Record> records = two_scenes();
  for (Record& one : records) {
    if (one.settings.at("rule") == "secant") one.failures.push_back({.reason = "slides off"});
  }
  EXPECT_EQ(placings(records, 1)[0].rule, "conjugate-vector");
  const std::string text = comparison_summary(records, Record{}, Screen{});
  EXPECT_THAT(text,
              HasSubstr("2 of 10 runs do not hold their scene, which is a result: secant 2."));
}

TEST(ComparisonSummary, OfWorkAndPrecisionTellsTheCheapestSettingAndWhatBroke) {
  Record one;
  one.case_name = std::string(kWorkPrecision) + "creep/cells=2/dt=1e-4";
  one.configuration = "quiet";
  one.settings = {{"method", "quiet"}, {"rule", "conjugate-vector"}};
  one.figures = {{kErrorAtMost, "m/s", "", 2e-7},
                 {kErrorDoubt, "m/s", "", 1e-13},
                 {kWorkTime, "s/s", "", 0.05},
                 {kWorkSpread, "1", "", 1.0}};
  Record broken = one;
  broken.failures.push_back({.reason = "it did not hold"});
  const std::string text = comparison_summary({one, broken}, Record{}, Screen{});
  EXPECT_THAT(text, HasSubstr("creep, m/s 1e-3…1e-6"));
  EXPECT_THAT(text, HasSubstr("creep 1 of 2"));
  EXPECT_THAT(text, Not(HasSubstr("do not hold their scene")));
}

TEST(ComparisonSummary, TellsWhatBrokeOffWholeAndHowToRunItAgain) {
  std::vector<Record> records = two_scenes();
  records[1].verdict = Verdict::kError;
  records[1].error = "a body left the scene";
  const std::string text = comparison_summary(records, Record{}, Screen{});
  EXPECT_THAT(text, HasSubstr("ERROR rules/a, stored-vector on quiet contacts: a body left the"));
  EXPECT_THAT(text, HasSubstr("again: ./stiction compare --scene 'rules/a' --rule stored-vector "
                              "--contacts quiet"));
}

TEST(ComparisonSummary, OfAFewRulesAllArePlaced) {
  std::vector<Record> records = two_scenes();
  std::erase_if(records, [](const Record& one) { return one.settings.at("rule") == "none"; });
  const std::string text = comparison_summary(records, Record{}, Screen{});
  for (const char* words : {"fixed-point", "stored-vector", "secant", "3e-05 m/s"}) {
    EXPECT_THAT(text, HasSubstr(words));
  }
}

TEST(ComparisonSummary, FitsTheScreenAndCutsNothing) {
  for (const std::size_t width : {40u, 80u, 200u}) {
    const std::string text = comparison_summary(two_scenes(), Record{}, {.width = width});
    EXPECT_THAT(text, Not(HasSubstr("…c")));
    EXPECT_THAT(text, HasSubstr("conjugate-vector"));
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(display_width(line), std::max<std::size_t>(width, 46)) << line;
    }
  }
}

}  // namespace
}  // namespace stiction
