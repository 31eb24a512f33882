// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/old_record.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/record/record_json.h"
#include "reports/record/test_records.h"

namespace stiction {
namespace {

// A check as schema version 3 wrote it.
nlohmann::json old_check() {
  return {
      {"quantity", "drift"}, {"unit", "m"},        {"claim", "a box at rest stays"},
      {"source", "statics"}, {"kind", "analytic"}, {"value", 2e-6},
      {"expected", 0.0},     {"error", 2e-6},      {"relative", false},
      {"scale", 1.0},        {"tolerance", 1e-6},  {"reason", "the paper's slip over the window"},
      {"digits", 5.7},       {"cause", ""},        {"verdict", "fail"}};
}

Record read(int version, const nlohmann::json& check, const std::vector<std::string>& notes = {}) {
  auto json = nlohmann::json::parse(to_json_line(test::passing_record()));
  json["schema_version"] = version;
  json["checks"] = nlohmann::json::array({check});
  json["notes"] = notes;
  json.erase("figures");
  json.erase("failures");
  json.erase("variant");
  return from_json_line(json.dump(), "here");
}

TEST(OldRecord, DigitsOfNoScaleAreLeftOut) {
  const Judgement check = read(3, old_check()).checks.at(0);
  EXPECT_EQ(check.digits, std::nullopt);
  EXPECT_EQ(check.claim.scale, std::nullopt);
  EXPECT_DOUBLE_EQ(check.of_tolerance, 2.0);
  EXPECT_EQ(check.claim.statement, "a box at rest stays");
}

TEST(OldRecord, DigitsOfAScaleStay) {
  auto json = old_check();
  json["scale"] = 0.2;
  EXPECT_EQ(read(3, json).checks.at(0).digits, 5.7);
  EXPECT_EQ(read(3, json).checks.at(0).claim.scale, 0.2);
  json["scale"] = 1.0;
  json["expected"] = 1.0;
  EXPECT_EQ(read(3, json).checks.at(0).digits, 5.7);
  EXPECT_EQ(read(3, json).checks.at(0).claim.scale, std::nullopt) << "the expected value is it";
}

TEST(OldRecord, LimitOfVersionThreeIsAShortfallWithItsBand) {
  auto json = old_check();
  json["verdict"] = "limit";
  json["cause"] = "normal forces never settle";
  json["expected_low"] = 1e-6;
  json["expected_high"] = "inf";
  const Judgement check = read(3, json).checks.at(0);
  EXPECT_EQ(check.verdict, Verdict::kShortfall);
  ASSERT_TRUE(check.band.has_value());
  EXPECT_EQ(check.band->low, 1e-6);
  EXPECT_EQ(check.band->high, test::kInf);
  EXPECT_EQ(check.cause, "normal forces never settle");
}

TEST(OldRecord, LimitOfVersionTwoIsACauseWithoutABand) {
  auto json = old_check();
  json["verdict"] = "limit";
  json.erase("cause");
  json["limit"] = "never settles";
  const Judgement check = read(2, json).checks.at(0);
  EXPECT_EQ(check.verdict, Verdict::kShortfall);
  EXPECT_EQ(check.cause, "never settles");
  EXPECT_FALSE(check.band.has_value());
}

TEST(OldRecord, FiguresAndFailuresWereChecksAndNotes) {
  auto json = old_check();
  json["verdict"] = "shown";
  json["tolerance"] = 0.0;
  json["reason"] = "none: rules are set side by side, not judged";
  json["value"] = "inf";
  const Record record =
      read(3, json,
           {"a note", "failed: a body moved by 9 mm", "failed: gain = -0.5, 2.3", "it failed: no"});
  EXPECT_TRUE(record.checks.empty());
  ASSERT_EQ(record.figures.size(), 1u);
  EXPECT_EQ(record.figures[0].quantity, "drift");
  EXPECT_EQ(record.figures[0].value, test::kInf);
  ASSERT_EQ(record.failures.size(), 2u);
  EXPECT_EQ(record.failures[0].reason, "a body moved by 9 mm");
  EXPECT_TRUE(record.failures[0].values.empty());
  EXPECT_EQ(record.failures[1].parameter, "gain");
  EXPECT_EQ(record.failures[1].values, (std::vector<double>{-0.5, 2.3}));
  EXPECT_EQ(record.notes, (std::vector<std::string>{"a note", "it failed: no"}));
}

Failure only_failure(const std::string& text) {
  return read(3, old_check(), {"failed: " + text}).failures.at(0);
}

TEST(OldRecord, ValuesOfAFailureAreDecimalNumbers) {
  const Failure failure = only_failure("gain = 1e+20, 1e-05, -0.5, 5e-324, 1E3, .5");
  EXPECT_EQ(failure.parameter, "gain");
  EXPECT_EQ(failure.values, (std::vector<double>{1e20, 1e-5, -0.5, 5e-324, 1e3, 0.5}));
}

TEST(OldRecord, AFailureWithoutSuchValuesIsATextAsItStands) {
  for (const char* text : {"gain = ...",    "gain = .",
                           "gain = -",      "gain = e",
                           "gain = 1e",     "gain = +1",
                           "gain = --1",    "gain = 1.2.3",
                           "gain = 0x10",   "gain = nan",
                           "gain = -inf",   "gain = 1e999",
                           "gain = 1e-999", "gain = 1, 1e999",
                           "gain = 1,2",    "gain = 1 ",
                           "gain = 1, ",    "gain = ",
                           "gain  = 1",     "gain\t= 1",
                           "the gain = 1",  " = 1",
                           "gain",          ""}) {
    const Failure failure = only_failure(text);
    EXPECT_EQ(failure.reason, text);
    EXPECT_EQ(failure.parameter, "") << text;
    EXPECT_TRUE(failure.values.empty()) << text;
  }
}

TEST(OldRecord, AFailureMayBeOfAnyLength) {
  constexpr std::size_t kMany = 300'000;
  const std::string word(kMany, 'a');
  EXPECT_EQ(only_failure(word).reason, word);
  std::string list = word + " = 1";
  for (std::size_t k = 1; k < kMany; ++k) list += ", 1";
  EXPECT_EQ(only_failure(list).values.size(), kMany);
}

TEST(OldRecord, AShownCheckWithAToleranceStaysACheck) {
  auto json = old_check();
  json["verdict"] = "shown";
  const Record record = read(3, json);
  EXPECT_EQ(record.checks.at(0).verdict, Verdict::kForInformation);
}

}  // namespace
}  // namespace stiction
