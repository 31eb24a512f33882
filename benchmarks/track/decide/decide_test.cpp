// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/decide/decide.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stiction::track {
namespace {

Measurement measured(Kind kind, std::vector<double> samples) {
  return {{"a", "b", "1", kind}, std::move(samples)};
}

// `scale` times twelve values that scatter by ±1 % around 1, in no order.
Measurement times(double scale, double spread = 0.01) {
  std::vector<double> samples;
  for (int k = 0; k < 12; ++k) samples.push_back(scale * (1.0 + spread * std::sin(2.4 * k)));
  return measured(Kind::kTime, samples);
}

Change change(Kind kind, double before, double after) {
  return compare(measured(kind, {before}), measured(kind, {after})).change;
}

TEST(Decide, TimesThatMovedBeyondTheNoise) {
  EXPECT_EQ(compare(times(1.0), times(1.05)).change, Change::kWorse);
  EXPECT_EQ(compare(times(1.0), times(0.95)).change, Change::kBetter);
  EXPECT_EQ(compare(times(1.0), times(1.0)).change, Change::kSame);
}

// Significant (no value overlaps) and yet no more than a change of addresses may do.
TEST(Decide, TimesBelowTheLayoutFloor) {
  const Comparison one = compare(times(1.0, 1e-4), times(1.02, 1e-4));
  EXPECT_LE(one.p, kLimits.significance);
  EXPECT_GT(one.low, 1.0);
  EXPECT_EQ(one.change, Change::kSame);
}

TEST(Decide, TimesBelowTheirOwnNoise) {
  const Comparison one = compare(times(1.0, 0.2), times(1.05, 0.2));
  EXPECT_GT(one.floor, std::log(1.05));
  EXPECT_EQ(one.change, Change::kSame);
}

TEST(Decide, CountsGateHard) {
  EXPECT_EQ(change(Kind::kCount, 1000, 1000), Change::kSame);
  EXPECT_EQ(change(Kind::kCount, 1000, 1005), Change::kSame);
  EXPECT_EQ(change(Kind::kCount, 1000, 1006), Change::kWorse);
  EXPECT_EQ(change(Kind::kCount, 1000, 994), Change::kBetter);
  EXPECT_EQ(change(Kind::kCount, 0, 0), Change::kSame);
  EXPECT_EQ(change(Kind::kCount, 0, 1), Change::kWorse);
  EXPECT_EQ(change(Kind::kCount, 1, 0), Change::kBetter);
}

TEST(Decide, DigitsAreBetterWhenMore) {
  EXPECT_EQ(change(Kind::kDigits, 6, 5), Change::kWorse);
  EXPECT_EQ(change(Kind::kDigits, 5, 6), Change::kBetter);
  EXPECT_EQ(change(Kind::kDigits, 6, 5.5), Change::kWorse);
  EXPECT_EQ(change(Kind::kDigits, 6, 5.6), Change::kSame);
}

TEST(Decide, AnyWorseVerdictCounts) {
  EXPECT_EQ(change(Kind::kVerdict, 0, 1), Change::kWorse);
  EXPECT_EQ(change(Kind::kVerdict, 2, 0), Change::kBetter);
  EXPECT_EQ(change(Kind::kVerdict, 1, 1), Change::kSame);
}

Measurements set(double time, double count, double digits) {
  Measurements all;
  for (const double sample : times(time).samples) all.add({"x", "time", "s", Kind::kTime}, sample);
  all.add({"x", "instructions", "1", Kind::kCount}, count);
  all.add({"x", "digits", "1", Kind::kDigits}, digits);
  return all;
}

TEST(Decide, WorstComesFirst) {
  const auto all = compare(set(1.0, 100, 6), set(0.9, 110, 4));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].metric.what, "digits");  // two digits are a factor 100, the count 1.1
  EXPECT_EQ(all[1].metric.what, "instructions");
  EXPECT_EQ(all[2].change, Change::kBetter);
  EXPECT_TRUE(any(all, Change::kWorse));
}

TEST(Decide, ATimeMustBeFoundTwice) {
  auto first = compare(set(1.0, 100, 6), set(1.1, 110, 6));
  confirm(first, compare(set(1.0, 100, 6), set(1.0, 100, 6)));
  ASSERT_EQ(first.size(), 3u);
  EXPECT_EQ(first[0].metric.what, "instructions");  // exact, needs no second run
  EXPECT_EQ(first[0].change, Change::kWorse);
  for (const Comparison& one : first) {
    if (one.metric.what != "time") continue;
    EXPECT_EQ(one.change, Change::kSame);
    EXPECT_TRUE(one.refuted);
  }
  auto again = compare(set(1.0, 100, 6), set(1.1, 100, 6));
  confirm(again, compare(set(1.0, 100, 6), set(1.1, 100, 6)));
  EXPECT_EQ(again[0].change, Change::kWorse);
  auto opposite = compare(set(1.0, 100, 6), set(1.1, 100, 6));
  confirm(opposite, compare(set(1.0, 100, 6), set(0.9, 100, 6)));
  EXPECT_FALSE(any(opposite, Change::kWorse));
  auto not_run_again = compare(set(1.0, 100, 6), set(1.1, 100, 6));
  confirm(not_run_again, {});
  EXPECT_FALSE(any(not_run_again, Change::kWorse));
}

TEST(Decide, MetricsOfOneSideAreNamed) {
  Measurements before, after;
  before.add({"x", "old", "1", Kind::kCount}, 1);
  after.add({"x", "new", "1", Kind::kCount}, 1);
  EXPECT_TRUE(compare(before, after).empty());
  EXPECT_EQ(missing(before, after), std::vector<std::string>{"x#old"});
  EXPECT_EQ(missing(after, before), std::vector<std::string>{"x#new"});
}

}  // namespace
}  // namespace stiction::track
