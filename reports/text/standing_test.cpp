// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/standing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/record/test_records.h"

namespace stiction {
namespace {

Judgement check(const char* quantity, double value, Verdict verdict, double of_tolerance) {
  Judgement one;
  one.claim.quantity = quantity;
  one.claim.tolerance = 1e-9;
  one.value = value;
  one.of_tolerance = of_tolerance;
  one.verdict = verdict;
  return one;
}

Record record(const char* name, const char* configuration, std::vector<Judgement> checks) {
  Record one;
  one.case_name = name;
  one.engine = "stiction";
  one.configuration = configuration;
  one.checks = std::move(checks);
  one.verdict = combined_verdict(one.checks);
  one.simulations = 1;
  one.cost = {.cpu_seconds = 2.0, .steps = 1000};
  return one;
}

Record resting(const char* name, const char* configuration) {
  return record(name, configuration, {check("fastest contact slip", 1e-16, Verdict::kPass, 0.01)});
}

Record creeping(const char* name, const char* configuration, Verdict verdict) {
  return record(name, configuration, {check("fastest contact slip", -3e-4, verdict, 3e5)});
}

TEST(Holds, GoesByWhatIsDecided) {
  EXPECT_TRUE(holds(resting("a", "quiet")));
  EXPECT_FALSE(holds(creeping("a", "paper", Verdict::kRefuted))) << "expected, but no rest";
  EXPECT_FALSE(holds(record("a", "old", {check("drift", 0.0, Verdict::kForInformation, 0.0)})))
      << "nobody judged it";
  EXPECT_TRUE(holds(record("a", "quiet",
                           {check("drift", 0.0, Verdict::kPass, 0.0),
                            check("bracket width", 1.0, Verdict::kForInformation, 1e9)})));
  EXPECT_FALSE(holds(record("a", "quiet", {})));
  EXPECT_FALSE(holds(record("a", "quiet", {check("drift", 1.0, Verdict::kFail, 0.2)})))
      << "at a scaled tolerance";
  Record broken = resting("a", "quiet");
  broken.verdict = Verdict::kError;
  EXPECT_FALSE(holds(broken));
}

TEST(Standings, ComparesThoseThatRanTheSameCases) {
  std::vector<Record> records;
  for (const char* name : {"a", "b", "c", "d"}) records.push_back(resting(name, "quiet"));
  for (const char* name : {"a", "b", "c"}) {
    records.push_back(creeping(name, "paper", Verdict::kRefuted));
    records.push_back(creeping(name, "old", Verdict::kForInformation));
  }
  records.push_back(resting("d", "paper, no memory"));
  const Standings all = standings_of(records);
  EXPECT_EQ(all.shared_cases, 3u);
  EXPECT_EQ(all.compared, 3u);
  ASSERT_EQ(all.rows.size(), 4u);
  EXPECT_EQ(all.rows[1].name, "old");
  EXPECT_EQ(all.rows[1].ran, 0u);
  EXPECT_EQ(all.rows[1].not_judged, 3u);
  const Standing& quiet = all.rows[0];
  EXPECT_EQ(quiet.name, "quiet");
  EXPECT_EQ(quiet.held_shared, 3u);
  EXPECT_EQ(quiet.shared, 3u);
  EXPECT_EQ(quiet.ran, 4u);
  EXPECT_DOUBLE_EQ(quiet.cpu_seconds, 6.0) << "of the shared cases alone";
  EXPECT_FALSE(quiet.creeps);
  const Standing& last = all.rows[3];
  EXPECT_EQ(last.name, "paper, no memory");
  EXPECT_FALSE(last.compared);
  EXPECT_EQ(last.held, 1u);
  for (const std::size_t row : {1u, 2u}) {
    EXPECT_EQ(all.rows[row].held_shared, 0u);
    EXPECT_TRUE(all.rows[row].creeps);
    ASSERT_TRUE(all.rows[row].slip.has_value());
    EXPECT_DOUBLE_EQ(*all.rows[row].slip, 3e-4);
  }
}

TEST(Standings, TellOfRunsThatEndedEarly) {
  Record early = creeping("a", "old", Verdict::kShortfall);
  early.cost.steps = 100;
  const Standings all = standings_of({resting("a", "quiet"), early});
  EXPECT_EQ(all.rows[0].ended_early, 0u);
  EXPECT_EQ(all.rows[1].ended_early, 1u);
}

TEST(Standings, NameTheEngineWhereThereAreSeveral) {
  Record bullet = resting("a", "best");
  bullet.engine = "bullet";
  const Standings all = standings_of({resting("a", "quiet"), bullet});
  EXPECT_EQ(all.rows[0].name, "bullet, best");
  EXPECT_EQ(all.rows[1].name, "stiction, quiet");
}

TEST(Standings, LeaveOutWhatIsNotApplicable) {
  Record lacking = record("b", "quiet", {});
  lacking.verdict = Verdict::kNotApplicable;
  const Standings all = standings_of({resting("a", "quiet"), lacking});
  ASSERT_EQ(all.rows.size(), 1u);
  EXPECT_EQ(all.rows[0].ran, 1u);
}

TEST(Standings, ANumberThatIsNoneIsWorst) {
  const Standings all =
      standings_of({record("a", "quiet",
                           {check("fastest contact slip", test::kNan, Verdict::kFail, test::kInf)}),
                    resting("b", "quiet")});
  ASSERT_TRUE(all.rows[0].slip.has_value());
  EXPECT_TRUE(std::isnan(*all.rows[0].slip));
}

}  // namespace
}  // namespace stiction
