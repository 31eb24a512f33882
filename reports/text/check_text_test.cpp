// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/check_text.h"

#include <gtest/gtest.h>

#include "reports/record/test_records.h"

namespace stiction {
namespace {

TEST(CheckText, AbsoluteErrorHasTheQuantitysUnit) {
  EXPECT_EQ(check_sentence(test::failing_check()),
            "stopping distance: measured 0.31 m, expected 0.3 m (analytic), error 0.01 m, "
            "tolerance 0.0001 m");
}

TEST(CheckText, RelativeErrorSaysSo) {
  EXPECT_EQ(check_sentence(test::passing_check()),
            "critical slope, tan θ: measured 0.300012, expected 0.3 (analytic), error 4e-05 rel, "
            "tolerance 0.0001 rel");
}

TEST(CheckText, AReferenceFromOutsideSaysWhose) {
  Judgement check = test::passing_check();
  check.claim.kind = ReferenceKind::kExternal;
  check.claim.source = "table 3 of\nthe handbook";
  EXPECT_NE(check_sentence(check).find("expected 0.3 (external: table 3 of the handbook), error"),
            std::string::npos)
      << check_sentence(check);
  check.claim.source.clear();
  EXPECT_NE(check_sentence(check).find("expected 0.3 (external), error"), std::string::npos);
}

// As band_text() of the page, web/test/model_test.mjs.
TEST(CheckText, ABandSaysOnWhichSideAValueLies) {
  const auto banded = [](double value, Verdict verdict) {
    Judgement check = test::shortfall_record().checks.front();
    check.band = Band{0.31, 0.35};
    check.value = value;
    check.verdict = verdict;
    return band_text(check);
  };
  EXPECT_EQ(banded(0.32, Verdict::kRefuted), ", as expected in [0.31, 0.35] m");
  EXPECT_EQ(banded(3e5, Verdict::kFail), ", worse than expected [0.31, 0.35] m");
  EXPECT_EQ(banded(0.28, Verdict::kFail), ", worse than expected [0.31, 0.35] m")
      << "farther on the other side";
  EXPECT_EQ(banded(0.3001, Verdict::kFail), ", better than known [0.31, 0.35] m: raise the bar");
  EXPECT_EQ(banded(0.32, Verdict::kFail), ", better than known [0.31, 0.35] m: raise the bar")
      << "it holds its claim";
  EXPECT_EQ(banded(test::kNan, Verdict::kFail),
            ", no number where it is expected in [0.31, 0.35] m");
  EXPECT_EQ(band_text(test::failing_check()), "");
}

TEST(CheckText, HostileTextStaysOnOneLine) {
  const std::string text = check_sentence(test::hostile_record().checks.front());
  EXPECT_EQ(text.find_first_of("\n\r\t\x1b"), std::string::npos);
  EXPECT_NE(text.find("measured nan"), std::string::npos);
}

TEST(CheckText, ShareOfTheTolerance) {
  EXPECT_EQ(share_text(0.0), "exact");
  EXPECT_EQ(share_text(0.123), "12 %");
  EXPECT_EQ(share_text(1.0), "100 %");
  EXPECT_EQ(share_text(3.44), "3.4 ×");
  EXPECT_EQ(share_text(320.4), "320 ×");
  EXPECT_EQ(share_text(2.6e7), "3e+07 ×");
  EXPECT_EQ(share_text(6.7e-13), "<0.01 %");
  EXPECT_EQ(share_text(test::kInf), "∞");
}

TEST(CheckText, AFailureNamesTheValuesAtWhichItBroke) {
  EXPECT_EQ(failure_text({"a body moved", "", {}}), "a body moved");
  EXPECT_EQ(failure_text({"a body moved", "gain", {-0.5, 2.3}}),
            "a body moved at gain = -0.5, 2.3");
}

TEST(CheckText, Settings) {
  EXPECT_EQ(settings_text({}), "");
  EXPECT_EQ(settings_text({{"rule", "none"}, {"dt", "1e-3"}}), "dt=1e-3 rule=none");
}

}  // namespace
}  // namespace stiction
