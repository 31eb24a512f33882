// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/testing/test_scenes.h"
#include "validation/comparison/comparison.h"
#include "validation/comparison/comparison_table.h"

namespace stiction {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

Record record(const std::string& name, const std::string& rule, double steps, double creep) {
  Record one;
  one.case_name = name;
  one.engine = "stiction";
  one.settings = {{"method", "quiet"}, {"rule", rule}};
  one.figures = {{kStepsTo6, "1", "", steps},
                 {kStepsTo9, "1", "", steps},
                 {kCreep, "m/s", "", creep},
                 {kSlipped, "m", "", creep}};
  return one;
}

Record cost(const std::string& rule, double ratio) {
  Record one;
  one.case_name = "cost/plate";
  one.settings = {{"method", "quiet"}, {"rule", rule}};
  one.figures = {{kFrictionRatio, "1", "", ratio}};
  return one;
}

std::vector<Record> two_scenes(double ratio) {
  return {cost("fixed-point", 1.0),
          cost("secant", 1.1),
          cost("stored-vector", ratio),
          record("rules/slab", "fixed-point", test::kInfinity, 1e-5),
          record("rules/slab", "secant", test::kInfinity, 2e-5),
          record("rules/slab", "stored-vector", 7, 1e-10),
          record("rules/box", "fixed-point", 90, 1e-8),
          record("rules/box", "secant", 80, 3e-8),
          record("rules/box", "stored-vector", 70, 1e-12)};
}

TEST(Findings, NameTheRuleThatBeatsBothAndItsCost) {
  const Record found = findings(two_scenes(0.9));
  EXPECT_THAT(found.notes,
              Contains(testing::AllOf(
                  HasSubstr("these beat every reading of"),
                  HasSubstr("stored-vector on quiet contacts, 0.9 × the friction cost"))));
}

TEST(Findings, SaySoWhenItCostsTooMuch) {
  const Record found = findings(two_scenes(1.3));
  EXPECT_THAT(found.notes, Contains(HasSubstr("No rule at up to 1.2 ×")));
  EXPECT_THAT(found.notes, Contains(HasSubstr("At a higher cost: stored-vector")));
}

TEST(Findings, SaySoWhenTheCostWasNotMeasured) {
  std::vector<Record> records = two_scenes(0.9);
  records.erase(records.begin(), records.begin() + 3);
  const Record found = findings(records);
  EXPECT_THAT(found.notes, Contains(HasSubstr("not measured in this run: stored-vector")));
  EXPECT_THAT(found.notes, Not(Contains(HasSubstr("No rule at up to"))));
}

TEST(Findings, DoNotNameARuleThatLosesOneScene) {
  std::vector<Record> records = two_scenes(0.9);
  records.back().figures[0].value = 85;  // steps; the secant needs 80
  EXPECT_THAT(findings(records).notes, Contains(HasSubstr("No rule at up to")));
}

TEST(Findings, CompareFixedPointAndSecantByTheirCreep) {
  EXPECT_THAT(findings(two_scenes(1.0)).notes,
              Contains(testing::AllOf(HasSubstr("median of 2 scenes; 2 to 3"),
                                      HasSubstr("fixed point 90 steps, secant 80 steps"),
                                      HasSubstr("comparable: confirmed"))));
  std::vector<Record> records = two_scenes(1.0);
  records[4].figures[2].value = 1e-3;
  EXPECT_THAT(findings(records).notes, Contains(HasSubstr("comparable: not confirmed")));
}

TEST(Findings, CountFailuresAndLeaveThemOutOfTheBest) {
  std::vector<Record> records = {record("hard/noise", "none", test::kInfinity, 1e-5),
                                 record("hard/noise", "secant", test::kInfinity, 1e-9)};
  records[1].failures = {{"a body moved by 9 mm", "", {}}};
  EXPECT_THAT(findings(records).notes,
              Contains(testing::AllOf(HasSubstr("least slipped on quiet contacts by none"),
                                      HasSubstr("1 of 2 fail"))));
}

TEST(Findings, NameNobodyAsNearestWhereNoneGetsThere) {
  EXPECT_THAT(findings({record("rules/slab", "none", test::kInfinity, 1e-5)}).notes,
              Contains(HasSubstr("none gets to 1e-9 m/s in all its steps.")));
}

TEST(Findings, AreSilentOnWhatWasNotCompared) {
  EXPECT_TRUE(findings({cost("none", 1.0)}).notes.empty());
}

TEST(ComparisonTable, HasARowARuleAndSaysNever) {
  const std::vector<Record> records = two_scenes(1.0);
  const std::string table = comparison_table({&records[3], &records[5]});
  EXPECT_THAT(table, HasSubstr("| fixed-point   | quiet    |"));
  EXPECT_THAT(table, HasSubstr("never"));
  EXPECT_THAT(table, HasSubstr("1e-10"));
  EXPECT_THAT(table, Not(HasSubstr("Failed")));
}

Record work(const std::string& build, double seconds, double share) {
  Record one;
  one.case_name = "work/slab/cells=2/dt=1e-4";
  one.engine = build.empty() ? "stiction" : "stiction_" + build;
  one.settings = {{"method", "quiet"}, {"rule", "fixed-point"}};
  if (!build.empty()) one.settings["build"] = build;
  one.figures = {
      {kSlippedShare, "1", "", share}, {kCpuTime, "s", "", seconds}, {kCreep, "m/s", "", share}};
  return one;
}

TEST(Findings, SetSinglePrecisionBesideDouble) {
  const Record found = findings({work("", 0.3, 1e-6), work("single", 0.2, 4e-6)});
  EXPECT_THAT(
      found.notes,
      Contains(testing::AllOf(HasSubstr("Work in single precision beside the same rule"),
                              HasSubstr("(1 pair): speed × 1.5 "), HasSubstr("way slipped × 4 "))));
  // Each is a point of its own in the front.
  EXPECT_THAT(found.notes,
              Contains(HasSubstr("fixed-point on quiet contacts in single precision")));
}

// Its own default of a parameter is no reading of the rule.
TEST(Findings, KnowARuleInABuildWithOtherDefaults) {
  std::vector<Record> both{work("", 0.3, 1e-6), work("single", 0.2, 4e-6)};
  for (Record& one : both) one.settings["rule"] = "conjugate-vector";
  both[0].settings["slip-tolerance"] = "1e-07";
  both[1].settings["slip-tolerance"] = "1e-06";
  EXPECT_THAT(findings(both).notes, Contains(HasSubstr("(1 pair)")));
}

// The program was not built: nothing was compared, and nothing failed.
TEST(Findings, SayNothingOfABuildThatIsNotThere) {
  Record missing = work("single", 0.0, 0.0);
  missing.figures.clear();
  missing.verdict = Verdict::kNotApplicable;
  const Record found = findings({work("", 0.3, 1e-6), missing});
  EXPECT_THAT(found.notes, Not(Contains(HasSubstr("single precision"))));
  EXPECT_THAT(found.notes, Contains(HasSubstr("None failed.")));
}

}  // namespace
}  // namespace stiction
