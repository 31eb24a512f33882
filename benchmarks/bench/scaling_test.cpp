// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/scaling.h"

#include <gtest/gtest.h>

namespace stiction::bench {
namespace {

Result lasting(const std::string& part, int size, double seconds) {
  Result one;
  one.chosen.timed.name = part;
  one.chosen.family.name = "slab";
  one.chosen.size = size;
  one.contacts = size;
  one.seconds = seconds;
  return one;
}

std::vector<Result> two_parts() {
  std::vector<Result> results;
  for (const int size : {100, 1000, 10000}) {
    results.push_back(lasting("detect", size, 2e-7 * size));
    results.push_back(lasting("depth", size, 1e-7 * size));
  }
  return results;
}

TEST(Scalings, FitsTheExponentOfEachPartAndOfTheSum) {
  const std::vector<Scaling> all = scalings(two_parts());
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[2].part, "detect + depth");
  EXPECT_DOUBLE_EQ(all[2].seconds[1], 3e-4);
  // Round-off of logarithms of order ten, over a range of order five.
  for (const Scaling& scaling : all) EXPECT_NEAR(scaling.law.exponent, 1.0, 1e-14);
}

TEST(Scalings, LeavesOutWhatWasMeasuredAtTwoSizes) {
  std::vector<Result> results = two_parts();
  results.pop_back();
  const std::vector<Scaling> all = scalings(results);
  ASSERT_EQ(all.size(), 1u) << "neither depth nor the sum";
  EXPECT_EQ(all[0].part, "detect");
}

}  // namespace
}  // namespace stiction::bench
