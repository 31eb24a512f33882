// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/check_text.h"

#include <gtest/gtest.h>

#include "reports/test_records.h"

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

TEST(CheckText, HostileTextStaysOnOneLine) {
  const std::string text = check_sentence(test::hostile_record().checks.front());
  EXPECT_EQ(text.find_first_of("\n\r\t\x1b"), std::string::npos);
  EXPECT_NE(text.find("measured nan"), std::string::npos);
}

TEST(CheckText, Settings) {
  EXPECT_EQ(settings_text({}), "");
  EXPECT_EQ(settings_text({{"rule", "none"}, {"dt", "1e-3"}}), "dt=1e-3 rule=none");
}

}  // namespace
}  // namespace stiction
