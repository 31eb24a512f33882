// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/statistics/two_samples.h"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace stiction::reference {
namespace {

// The same p-value by brute force: U, counted pair by pair, for each way to deal the values.
double enumerated_p(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> pooled = a;
  pooled.insert(pooled.end(), b.begin(), b.end());
  const auto twice_u = [&](const std::vector<bool>& in_a) {
    int u = 0;
    for (std::size_t i = 0; i < pooled.size(); ++i) {
      for (std::size_t j = 0; j < pooled.size(); ++j) {
        if (!in_a[i] || in_a[j]) continue;
        u += pooled[i] > pooled[j] ? 2 : pooled[i] == pooled[j] ? 1 : 0;
      }
    }
    return u;
  };
  const int mean = static_cast<int>(a.size() * b.size());
  std::vector<bool> dealt(pooled.size(), false);
  std::fill_n(dealt.begin(), a.size(), true);
  const int observed = std::abs(twice_u(dealt) - mean);
  std::sort(dealt.begin(), dealt.end());
  int all = 0, far = 0;
  do {
    ++all;
    far += std::abs(twice_u(dealt) - mean) >= observed ? 1 : 0;
  } while (std::next_permutation(dealt.begin(), dealt.end()));
  return static_cast<double>(far) / all;
}

// A generator and samples of exp(σ · normal), whose true ratio of medians is `ratio`.
class Draw {
 public:
  std::vector<double> sample(std::size_t size, double ratio, double sigma) {
    std::vector<double> values(size);
    for (double& value : values) value = ratio * gsl_ran_lognormal(random_.get(), 0.0, sigma);
    return values;
  }

 private:
  std::unique_ptr<gsl_rng, decltype(&gsl_rng_free)> random_{gsl_rng_alloc(gsl_rng_taus2),
                                                            &gsl_rng_free};
};

TEST(MannWhitney, EqualsTheEnumeration) {
  const std::vector<std::pair<std::vector<double>, std::vector<double>>> samples = {
      {{1, 2, 3}, {4, 5, 6}},       {{1, 4, 5}, {2, 3, 6}},
      {{1}, {2, 3, 4, 5}},          {{1, 2, 2, 7}, {2, 3, 9, 9}},
      {{5, 5, 5}, {5, 5}},          {{0.1, -3, 8}, {8, 8, 1e9, -4}},
      {{1, 2, 3, 4, 5}, {6, 7, 8}}, {{1, 3, 5, 7}, {2, 4, 6, 8, 10}}};
  for (const auto& [a, b] : samples) {
    EXPECT_NEAR(mann_whitney_p(a, b), enumerated_p(a, b), 1e-15);
    EXPECT_NEAR(mann_whitney_p(b, a), enumerated_p(a, b), 1e-15);
  }
}

// Two groups of 9 that don't overlap: 2 of C(18, 9) = 48620 ways.
TEST(MannWhitney, OfSeparateSamples) {
  std::vector<double> a(9), b(9);
  std::iota(a.begin(), a.end(), 0.0);
  std::iota(b.begin(), b.end(), 100.0);
  EXPECT_DOUBLE_EQ(mann_whitney_p(a, b), 2.0 / 48620.0);
  EXPECT_DOUBLE_EQ(mann_whitney_p(a, a), 1.0);
}

// A test at level p is wrong in at most p of the cases where nothing changed. 4000 trials: three
// standard deviations of a binomial are 3 √(0.05 · 0.95 / 4000) = 0.0103.
TEST(MannWhitney, IsRarelyWrong) {
  Draw draw;
  int wrong = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    wrong += mann_whitney_p(draw.sample(9, 1, 0.1), draw.sample(9, 1, 0.1)) <= 0.05 ? 1 : 0;
  }
  EXPECT_LE(wrong / 4000.0, 0.05 + 0.0103);
  EXPECT_GE(wrong / 4000.0, 0.03);  // the largest attainable level below 0.05 is 0.040
}

// The percentile bootstrap of medians of 12 is known to cover somewhat less than it says; it must
// not be far off. 2000 trials: three standard deviations are 3 √(0.95 · 0.05 / 2000) = 0.015.
TEST(Bootstrap, CoversTheTrueRatio) {
  Draw draw;
  int inside = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Interval interval =
        bootstrap_median_ratio(draw.sample(12, 1.0, 0.05), draw.sample(12, 1.07, 0.05), 0.95, 400,
                               static_cast<std::uint64_t>(trial));
    inside += interval.low <= 1.07 && 1.07 <= interval.high ? 1 : 0;
  }
  EXPECT_GE(inside / 2000.0, 0.93);
  EXPECT_LE(inside / 2000.0, 0.99);
}

TEST(Bootstrap, IsRepeatable) {
  const std::vector<double> a = {1, 1.1, 0.9, 1.05}, b = {2, 2.1, 1.9, 2.2};
  const Interval first = bootstrap_median_ratio(a, b, 0.95, 1000, 7);
  const Interval again = bootstrap_median_ratio(a, b, 0.95, 1000, 7);
  EXPECT_EQ(first.low, again.low);
  EXPECT_EQ(first.high, again.high);
  EXPECT_GT(first.low, 1.9 / 1.1 - 1e-12);
  EXPECT_LT(first.high, 2.2 / 0.9 + 1e-12);
}

// Of equal size and spread: what an A/A comparison shows at the same level (sampled directly).
TEST(SplitHalfNoise, IsThatOfTwoSamplesOfTheSame) {
  Draw draw;
  std::vector<double> apart, claimed;
  for (int trial = 0; trial < 400; ++trial) {
    const std::vector<double> a = draw.sample(16, 3.0, 0.02);
    apart.push_back(std::abs(std::log(median(draw.sample(16, 3.0, 0.02)) / median(a))));
    claimed.push_back(split_half_noise(a, 0.95, 1));
  }
  std::sort(apart.begin(), apart.end());
  // A quantile of 400 scatters by ≈ 7 %; medians of 8 of the same 16 are not quite independent.
  EXPECT_NEAR(median(claimed) / apart[379], 1.0, 0.35);
  EXPECT_EQ(split_half_noise({2, 2, 2, 2, 2}, 0.95, 1), 0.0);
}

TEST(TwoSamples, RefuseWhatTheyCannotJudge) {
  EXPECT_THROW(mann_whitney_p({}, {1.0}), std::invalid_argument);
  EXPECT_THROW(mann_whitney_p({NAN}, {1.0}), std::invalid_argument);
  EXPECT_THROW(bootstrap_median_ratio({0.0}, {1.0}, 0.95, 10, 1), std::invalid_argument);
  EXPECT_THROW(bootstrap_median_ratio({}, {1.0}, 0.95, 10, 1), std::invalid_argument);
  EXPECT_THROW(split_half_noise({1, 2, 3}, 0.95, 1), std::invalid_argument);
  EXPECT_THROW(split_half_noise({1, 2, 3, -4}, 0.95, 1), std::invalid_argument);
  EXPECT_THROW(median({}), std::invalid_argument);
  EXPECT_THROW(quartiles({}), std::invalid_argument);
}

TEST(Quartiles, LieBetweenTheSortedValues) {
  const Quartiles of_five = quartiles({5.0, 1.0, 4.0, 2.0, 3.0});
  EXPECT_EQ(of_five.lower, 2.0);
  EXPECT_EQ(of_five.median, 3.0);
  EXPECT_EQ(of_five.upper, 4.0);
  const Quartiles of_two = quartiles({2.0, 1.0});
  EXPECT_EQ(of_two.lower, 1.25);
  EXPECT_EQ(of_two.median, 1.5);
  EXPECT_EQ(of_two.upper, 1.75);
}

}  // namespace
}  // namespace stiction::reference
