// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/judge/show_expectations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "validation/judge/test_cause.h"

namespace stiction {
namespace {

using test::kCause;
using test::kWidth;
using testing::HasSubstr;
using testing::Not;

EngineKind engine_with_rows() {
  EngineKind engine = find_engine("stiction");
  engine.expectations = {
      {"a/one", "method=paper", "slip", {1e-6, 9e-6}, Verdict::kShortfall, kCause, kWidth},
      {"a/one", "method=paper", "drift", {1e-3, 2e-3}, Verdict::kRefuted, kCause, kWidth},
      {"b/*", "method=paper", "slip", {1e-6, 9e-6}, Verdict::kShortfall, kCause, kWidth}};
  return engine;
}

Judgement check_of(const std::string& quantity, double value) {
  return judge({.quantity = quantity, .tolerance = 1e-9}, value);
}

Record record_of(const std::vector<Judgement>& checks) {
  Record record;
  record.case_name = "a/one";
  record.engine = "stiction";
  record.variant = "method=paper";
  record.checks = checks;
  return record;
}

std::string shown(const std::vector<Judgement>& checks) {
  return show_expectations({record_of(checks)}, engine_with_rows());
}

TEST(ShowExpectations, LeavesARowThatHoldsItsValue) {
  const std::string text = shown({check_of("slip", 3e-6), check_of("drift", 1.5e-3)});
  EXPECT_THAT(text,
              HasSubstr(R"(    {"a/one", "method=paper", "slip", {1e-06, 9e-06}, kShortfall, )"
                        "kCause, kWidth},  // inside: 3e-06\n"));
  EXPECT_THAT(text, HasSubstr("kRefuted, kCause, kWidth},  // inside: 0.0015\n"));
  EXPECT_THAT(text, HasSubstr("// 1 rows are of cases that did not run"));
}

TEST(ShowExpectations, ProposesABandThatHoldsTheValue) {
  const std::string text = shown({check_of("slip", 1e-3), check_of("drift", 1.5e-3)});
  EXPECT_THAT(text, HasSubstr(R"("slip", {0.00033, 0.003}, kShortfall, kCause, kFactorThree},  // )"
                              "OUTSIDE [1e-06, 9e-06]: 0.001"));
  EXPECT_THAT(shown({check_of("slip", -1e-3)}), HasSubstr("{-0.003, -0.00033}"));
}

TEST(ShowExpectations, NamesRowsThatHaveToGo) {
  const std::string text = shown({check_of("slip", 1e-10)});
  EXPECT_THAT(text, HasSubstr("holds now, 1e-10: remove it"));
  EXPECT_THAT(text, HasSubstr("// meets no check: remove it"));
}

TEST(ShowExpectations, NamesFailuresWithoutARow) {
  const std::string text =
      shown({check_of("slip", 3e-6), check_of("drift", 1.5e-3), check_of("energy", 2.0)});
  EXPECT_THAT(text,
              HasSubstr(R"({"a/one", "method=paper", "energy", {0.66, 6}, kShortfall, kUnknown)"));
  EXPECT_THAT(text, HasSubstr("// fails without an expectation: 2\n"));
  Judgement old = check_of("energy", 2.0);
  old.verdict = Verdict::kForInformation;
  EXPECT_THAT(shown({old}), Not(HasSubstr("energy")));
}

TEST(ShowExpectations, LeavesOutSettingsOfOnesOwn) {
  Record own = record_of({check_of("slip", 5.0)});
  own.variant.clear();
  const std::string text = show_expectations({own}, engine_with_rows());
  EXPECT_THAT(text, Not(HasSubstr("OUTSIDE")));
  EXPECT_THAT(text, HasSubstr("1 records of settings of one's own are left out"));
}

}  // namespace
}  // namespace stiction
