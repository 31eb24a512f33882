// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/progress.h"

#include <gtest/gtest.h>

namespace stiction {
namespace {

TEST(SecondsLeft, GoWithTheWorkThatIsLeft) {
  EXPECT_DOUBLE_EQ(seconds_left(30.0, 1.0, 4.0), 90.0);
  EXPECT_DOUBLE_EQ(seconds_left(30.0, 4.0, 4.0), 0.0);
  EXPECT_DOUBLE_EQ(seconds_left(30.0, 4.1, 4.0), 0.0) << "rounding";
}

TEST(SecondsLeft, AreNotToldBeforeTheyCanBe) {
  EXPECT_LT(seconds_left(1.0, 1.0, 4.0), 0.0);
  EXPECT_LT(seconds_left(30.0, 0.0, 4.0), 0.0);
}

TEST(Progress, PrintsNothingWhereNobodyLooks) {
  testing::internal::CaptureStderr();  // no terminal
  {
    Progress progress({"a", "b"}, {1.0, 2.0});
    progress.show();
    progress.finished(1);
    progress.show();
    progress.hide();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace stiction
