// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/tally.h"

#include <gtest/gtest.h>

#include "reports/record/test_records.h"

namespace stiction {
namespace {

TEST(TallyOf, CountsVerdictsAndCosts) {
  Record shown = test::passing_record();
  shown.verdict = Verdict::kForInformation;
  const Tally tally =
      tally_of({test::passing_record(), test::passing_record(), shown, test::failing_record(),
                test::shortfall_record(), test::refuted_record(), test::error_record(),
                test::not_applicable_record()});
  EXPECT_EQ(verdicts_text(tally),
            "2 pass, 1 fail, 1 expected shortfall, 1 refuted, 1 error, 1 not applicable, 1 for "
            "information");
  EXPECT_EQ(tally.records(), 8u);
  EXPECT_EQ(cost_text(tally), "CPU 1.75 s, 84,000 steps, 672,000 contact updates");
}

TEST(TallyOf, Nothing) {
  EXPECT_EQ(verdicts_text(tally_of({})),
            "0 pass, 0 fail, 0 expected shortfalls, 0 refuted, 0 errors, 0 not applicable, 0 for "
            "information");
}

}  // namespace
}  // namespace stiction
