// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/record.h"

#include <gtest/gtest.h>

#include <set>

#include "reports/record/test_records.h"

namespace stiction {
namespace {

Judgement check_with(Verdict verdict, double error = 0.0, double tolerance = 1.0) {
  Judgement check;
  check.verdict = verdict;
  check.error = error;
  check.claim.tolerance = tolerance;
  check.of_tolerance = share_of_tolerance(error, tolerance);
  return check;
}

constexpr Verdict kVerdicts[] = {
    Verdict::kPass,          Verdict::kFail,           Verdict::kShortfall, Verdict::kRefuted,
    Verdict::kNotApplicable, Verdict::kForInformation, Verdict::kError};
constexpr ReferenceKind kKinds[] = {ReferenceKind::kAnalytic, ReferenceKind::kExactComputed,
                                    ReferenceKind::kSelfConverged, ReferenceKind::kExternal,
                                    ReferenceKind::kGolden};

TEST(CombinedVerdict, IsTheWorstWhateverTheOrder) {
  const std::vector<Verdict> rising = {
      Verdict::kNotApplicable, Verdict::kForInformation, Verdict::kPass, Verdict::kRefuted,
      Verdict::kShortfall,     Verdict::kFail,           Verdict::kError};
  for (std::size_t worst = 0; worst < rising.size(); ++worst) {
    for (std::size_t other = 0; other <= worst; ++other) {
      const Judgement a = check_with(rising[worst]);
      const Judgement b = check_with(rising[other]);
      EXPECT_EQ(combined_verdict({a, b}), rising[worst]) << worst << " " << other;
      EXPECT_EQ(combined_verdict({b, a}), rising[worst]) << worst << " " << other;
    }
  }
}

TEST(CombinedVerdict, NothingToDecideIsNoPass) {
  EXPECT_EQ(combined_verdict({}), Verdict::kNotApplicable);
  EXPECT_EQ(combined_verdict({check_with(Verdict::kForInformation)}), Verdict::kForInformation);
}

TEST(WorstCheck, IsLargestAgainstItsOwnTolerance) {
  const std::vector<Judgement> checks = {
      check_with(Verdict::kPass, 1e9, 1.0), check_with(Verdict::kFail, 5.0, 1.0),
      check_with(Verdict::kFail, -0.1, 0.01), check_with(Verdict::kForInformation, 1e9, 1.0)};
  EXPECT_EQ(worst_check(checks), &checks[2]);
}

TEST(WorstCheck, NanAndZeroToleranceAreInfinite) {
  std::vector<Judgement> checks = {check_with(Verdict::kFail, 5.0, 1.0),
                                   check_with(Verdict::kFail, test::kNan, 1.0)};
  EXPECT_EQ(worst_check(checks), &checks[1]);
  checks[1] = check_with(Verdict::kFail, 1e-300, 0.0);
  EXPECT_EQ(worst_check(checks), &checks[1]);
  checks = {check_with(Verdict::kPass, 0.0, 0.0), check_with(Verdict::kPass, 0.5, 1.0)};
  EXPECT_EQ(worst_check(checks), &checks[1]) << "no error at tolerance 0 is no offence";
}

TEST(WorstCheck, NoneDecides) {
  EXPECT_EQ(worst_check({}), nullptr);
  const std::vector<Judgement> checks = {check_with(Verdict::kForInformation, 5.0)};
  EXPECT_EQ(worst_check(checks), nullptr);
}

TEST(RecordWords, ReadBackAndDiffer) {
  std::set<std::string> words;
  for (const Verdict verdict : kVerdicts) {
    words.insert(to_string(verdict));
    EXPECT_EQ(parse_verdict(to_string(verdict)), verdict);
  }
  for (const ReferenceKind kind : kKinds) {
    words.insert(to_string(kind));
    EXPECT_EQ(parse_reference_kind(to_string(kind)), kind);
  }
  EXPECT_EQ(words.size(), std::size(kVerdicts) + std::size(kKinds));
  EXPECT_EQ(to_string(Verdict::kNotApplicable), "not-applicable");
  EXPECT_EQ(to_string(ReferenceKind::kExactComputed), "exact-computed");
}

TEST(RecordWords, UnknownWordsGiveNothing) {
  for (const char* word : {"", "Pass", "pass ", "passed", "analytic"}) {
    EXPECT_FALSE(parse_verdict(word).has_value()) << word;
  }
  for (const char* word : {"", "Analytic", "exact", "pass"}) {
    EXPECT_FALSE(parse_reference_kind(word).has_value()) << word;
  }
}

}  // namespace
}  // namespace stiction
