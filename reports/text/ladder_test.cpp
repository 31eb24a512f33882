// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/ladder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/formats/digits_survive.h"
#include "reports/record/test_records.h"

namespace stiction {
namespace {

using testing::HasSubstr;
using testing::Not;

Record rung(const std::string& name, bool holds) {
  Record record = holds ? test::passing_record(name) : test::failing_record();
  record.case_name = name;
  return record;
}

TEST(Rung, IsReadFromACasesName) {
  const Record record = rung("ladder/mass-ratio/top=1e+04", true);
  const auto found = rung_of(record);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->ladder, "mass-ratio");
  EXPECT_EQ(found->parameter, "top");
  EXPECT_EQ(found->value, 1e4);
  for (const char* other : {"ladder", "ladder/x", "ladder/x=1", "ladder/x/y=", "ladder/x/y=1z",
                            "slab/rest/beta=1", "ladder/x=1/y"}) {
    EXPECT_FALSE(rung_of(rung(other, true))) << other;
  }
}

TEST(Climb, EndsAtTheFirstRungsThatBreakAboutTheTamest) {
  std::vector<Record> records;
  for (const auto& [value, holds] : {std::pair{"1e-06", true},
                                     {"1e-4", false},
                                     {"0.01", true},
                                     {"1", true},
                                     {"100", true},
                                     {"1e+04", false},
                                     {"1e6", true}}) {
    records.push_back(rung(std::string("ladder/x/y=") + value, holds));
  }
  const std::vector<Climb> climbs = climbs_of(records);
  ASSERT_EQ(climbs.size(), 1u);
  EXPECT_EQ(climbs[0].lowest->value, 0.01);
  EXPECT_EQ(climbs[0].highest->value, 100.0);
  EXPECT_EQ(climbs[0].below->value, 1e-4);
  EXPECT_EQ(climbs[0].above->value, 1e4);
  const std::string text = ladder_ends(records, 8, {.width = 100});
  EXPECT_THAT(text, HasSubstr("Ladders, 7 rungs"));
  EXPECT_THAT(text, HasSubstr("0.01 … 100"));
  EXPECT_THAT(text, HasSubstr("10000"));
}

TEST(Climb, OfWhatIsForInformationHoldsWithinItsTolerances) {
  Record within = rung("ladder/x/y=1", true), beyond = rung("ladder/x/y=10", false);
  for (Record* const record : {&within, &beyond}) {
    record->verdict = Verdict::kForInformation;
    for (Judgement& check : record->checks) check.verdict = Verdict::kForInformation;
  }
  const std::vector<Record> records = {within, beyond};
  const std::vector<Climb> climbs = climbs_of(records);
  ASSERT_NE(climbs[0].highest, nullptr);
  EXPECT_EQ(climbs[0].highest->value, 1.0);
  EXPECT_EQ(climbs[0].above->value, 10.0);
  EXPECT_THAT(ladder_ends(records, 8, {.width = 100}),
              HasSubstr(beyond.checks.front().claim.quantity));
}

TEST(Climb, MayHoldOnEveryRungOrNowhere) {
  const std::vector<Record> whole = {rung("ladder/x/y=0", true), rung("ladder/x/y=1", true)};
  EXPECT_EQ(climbs_of(whole)[0].lowest->value, 0.0);
  EXPECT_EQ(climbs_of(whole)[0].above, nullptr);
  EXPECT_THAT(ladder_ends(whole, 8, {.width = 100}), HasSubstr("hold on every rung: x"));
  const std::vector<Record> none = {rung("ladder/x/y=1", false)};
  EXPECT_EQ(climbs_of(none)[0].lowest, nullptr);
  EXPECT_THAT(ladder_ends(none, 8, {.width = 100}), HasSubstr("nowhere"));
  EXPECT_EQ(ladder_ends({test::passing_record()}, 8, {.width = 100}), "");
}

TEST(DigitsSurvive, TellsTheFewestOfEachPerturbation) {
  const auto perturbed = [](const std::string& name, double turned) {
    Record record = test::passing_record("perturbed/" + name);
    record.configuration = "quiet";
    record.checks.resize(1);
    record.checks[0].claim.quantity = "turned";
    record.checks[0].value = turned;
    record.checks[0].digits = correct_digits(turned, 1.0);
    return record;
  };
  const std::string text =
      digits_survive({perturbed("a", 1e-12), perturbed("b", 1e-9)}, 8, {.width = 100});
  EXPECT_THAT(text, HasSubstr("Digits that survive (2 cases)"));
  EXPECT_THAT(text, HasSubstr("9.0"));
  EXPECT_THAT(text, HasSubstr("b\n"));
  EXPECT_THAT(digits_survive({perturbed("a", 0.0)}, 8, {.width = 100}), HasSubstr("exact"));
  EXPECT_EQ(digits_survive({test::passing_record()}, 8, {.width = 100}), "");
}

}  // namespace
}  // namespace stiction
