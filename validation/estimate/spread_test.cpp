// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/estimate/spread.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stiction {
namespace {

TEST(Spread, NamesTheMiddleAndTheWorst) {
  const Spread odd = spread({3.0, 9.0, 1.0});
  EXPECT_EQ(odd.median, 3.0);
  EXPECT_EQ(odd.worst, 9.0);
  EXPECT_EQ(odd.worst_at, 1u);
  EXPECT_EQ(spread({4.0, 1.0, 2.0, 3.0}).median, 2.5);
  EXPECT_EQ(spread({}).worst, 0.0);
}

TEST(Spread, TakesWhatIsNoNumberForTheWorst) {
  const Spread found = spread({1.0, NAN, 2.0});
  EXPECT_EQ(found.worst, std::numeric_limits<double>::infinity());
  EXPECT_EQ(found.worst_at, 1u);
}

TEST(Spread, IsWorded) {
  EXPECT_EQ(spread_words(spread({1e-9, 2e-9, 3e-7}), "m"), "median 2.0e-09 m, worst 3.0e-07 m");
}

}  // namespace
}  // namespace stiction
