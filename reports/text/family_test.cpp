// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/family.h"

#include <gtest/gtest.h>

#include "reports/record/test_records.h"

namespace stiction {
namespace {

TEST(FamilyName, EndsBeforeTheFirstParameter) {
  EXPECT_EQ(family_name("incline/threshold/mu=0.3/azimuth=30"), "incline/threshold");
  EXPECT_EQ(family_name("incline/mu=0.3/azimuth=30"), "incline");
  EXPECT_EQ(family_name("incline/threshold"), "incline/threshold");
  EXPECT_EQ(family_name("incline/threshold/round/cone"), "incline/threshold");
  EXPECT_EQ(family_name("fall"), "fall");
  EXPECT_EQ(family_name("mu=0.3"), "mu=0.3");
  EXPECT_EQ(family_name(""), "");
}

TEST(NaturalOrder, NumbersByValue) {
  const std::vector<std::string> rising = {"",          "a/mu=0.05", "a/mu=0.1",  "a/mu=0.5",
                                           "a/mu=1",    "a/mu=1.0",  "a/mu=9",    "a/mu=10",
                                           "a/x=1e-12", "a/x=1e-4",  "a/x=1e999", "b"};
  for (std::size_t i = 0; i < rising.size(); ++i) {
    for (std::size_t j = 0; j < rising.size(); ++j) {
      // 1e999 is no double: it reads as characters and stands behind the numbers.
      EXPECT_EQ(natural_less(rising[i], rising[j]), i < j) << rising[i] << " < " << rising[j];
    }
  }
}

TEST(Families, AreSortedWhateverOrderJobsFinishedIn) {
  const std::vector<Record> records = {test::passing_record("incline/threshold/mu=0.9"),
                                       test::passing_record("fall"),
                                       test::passing_record("incline/threshold/mu=0.05"),
                                       test::passing_record("incline/threshold/mu=0.1")};
  const auto families = families_of(records);
  ASSERT_EQ(families.size(), 2u);
  EXPECT_EQ(families[0].name, "fall");
  EXPECT_EQ(families[1].name, "incline/threshold");
  const std::vector<const Record*> expected = {&records[2], &records[3], &records[0]};
  EXPECT_EQ(families[1].records, expected);
  EXPECT_TRUE(families_of({}).empty());
}

TEST(Families, LabelsTellSiblingsApart) {
  std::vector<Record> records = {test::passing_record("incline/threshold/mu=0.3"),
                                 test::passing_record("incline/threshold/mu=0.3"),
                                 test::passing_record("incline/threshold/mu=0.3")};
  records[1].settings["rule"] = "none";
  records[2].engine = "other";
  const Family family = families_of(records).front();
  EXPECT_EQ(family.common_settings, (std::map<std::string, std::string>{{"dt", "0.001"}}));
  EXPECT_EQ(family.label(records[1]), "mu=0.3 engine=stiction rule=none");
  EXPECT_EQ(family.label(records[2]), "mu=0.3 engine=other rule=fixed-point");
}

TEST(Families, LabelOfACaseThatIsItsFamily) {
  const std::vector<Record> records = {test::passing_record("fall")};
  EXPECT_EQ(families_of(records).front().label(records.front()), "fall");
}

TEST(Families, ASettingThatOneRecordLacksIsNotCommon) {
  std::vector<Record> records = {test::passing_record("a/x=1"), test::passing_record("a/x=2")};
  records[1].settings.erase("rule");
  const Family family = families_of(records).front();
  EXPECT_FALSE(family.common_settings.contains("rule"));
  EXPECT_EQ(family.label(records[0]), "x=1 rule=fixed-point");
  EXPECT_EQ(family.label(records[1]), "x=2");
}

}  // namespace
}  // namespace stiction
