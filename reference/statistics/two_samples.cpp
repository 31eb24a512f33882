// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/statistics/two_samples.h"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace stiction::reference {

namespace {

using Random = std::unique_ptr<gsl_rng, decltype(&gsl_rng_free)>;

Random seeded(std::uint64_t seed) {
  Random random(gsl_rng_alloc(gsl_rng_mt19937), &gsl_rng_free);
  gsl_rng_set(random.get(), seed);
  return random;
}

void demand_positive(const std::vector<double>& values) {
  for (const double value : values) {
    if (!(value > 0.0) || !std::isfinite(value)) {
      throw std::invalid_argument("A ratio of medians needs positive, finite values.");
    }
  }
}

// Twice the mid-rank of each value of the pooled sample: whole numbers, ties or not.
std::vector<std::size_t> doubled_ranks(const std::vector<double>& pooled) {
  std::vector<std::size_t> ranks;
  for (const double value : pooled) {
    std::size_t below = 0, equal = 0;
    for (const double other : pooled) {
      below += other < value ? 1 : 0;
      equal += other == value ? 1 : 0;
    }
    ranks.push_back(2 * below + equal + 1);
  }
  return ranks;
}

}  // namespace

double mann_whitney_p(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.empty() || b.empty()) throw std::invalid_argument("A rank test needs two samples.");
  std::vector<double> pooled = a;
  pooled.insert(pooled.end(), b.begin(), b.end());
  for (const double value : pooled) {
    if (std::isnan(value)) throw std::invalid_argument("A rank test cannot order NaN.");
  }
  const std::vector<std::size_t> ranks = doubled_ranks(pooled);
  std::size_t total = 0, observed = 0;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    total += ranks[i];
    if (i < a.size()) observed += ranks[i];
  }
  // ways[k][s]: subsets of k of the values seen so far whose doubled ranks sum to s.
  std::vector<std::vector<double>> ways(a.size() + 1, std::vector<double>(total + 1, 0.0));
  ways[0][0] = 1.0;
  for (const std::size_t rank : ranks) {
    for (std::size_t k = a.size(); k-- > 0;) {
      for (std::size_t s = 0; s + rank <= total; ++s) ways[k + 1][s + rank] += ways[k][s];
    }
  }
  // Distance from the mean |a|/(|a| + |b|) · total, times |a| + |b|: whole numbers.
  const auto distance = [&](std::size_t sum) {
    const auto scaled = static_cast<std::int64_t>(sum * pooled.size());
    return std::abs(scaled - static_cast<std::int64_t>(total * a.size()));
  };
  double all = 0.0, far = 0.0;
  for (std::size_t s = 0; s <= total; ++s) {
    all += ways[a.size()][s];
    if (distance(s) >= distance(observed)) far += ways[a.size()][s];
  }
  return far / all;
}

double median(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("An empty sample has no median.");
  return gsl_stats_median(values.data(), 1, values.size());
}

Quartiles quartiles(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("An empty sample has no quartiles.");
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return gsl_stats_quantile_from_sorted_data(values.data(), 1, values.size(), share);
  };
  return {at(0.25), at(0.5), at(0.75)};
}

Interval bootstrap_median_ratio(const std::vector<double>& a, const std::vector<double>& b,
                                double level, int resamples, std::uint64_t seed) {
  if (a.empty() || b.empty()) throw std::invalid_argument("A ratio needs two samples.");
  demand_positive(a);
  demand_positive(b);
  const Random random = seeded(seed);
  std::vector<double> from_a = a, from_b = b;  // GSL takes no constant arrays
  std::vector<double> drawn_a(a.size()), drawn_b(b.size()), ratios;
  for (int k = 0; k < resamples; ++k) {
    gsl_ran_sample(random.get(), drawn_a.data(), a.size(), from_a.data(), a.size(), sizeof(double));
    gsl_ran_sample(random.get(), drawn_b.data(), b.size(), from_b.data(), b.size(), sizeof(double));
    ratios.push_back(median(drawn_b) / median(drawn_a));
  }
  std::sort(ratios.begin(), ratios.end());
  const auto outside = static_cast<std::size_t>(0.5 * (1.0 - level) * resamples);
  return {ratios[outside], ratios[ratios.size() - 1 - outside]};
}

double split_half_noise(const std::vector<double>& sample, double level, std::uint64_t seed) {
  if (sample.size() < 4) throw std::invalid_argument("Too few values to measure their noise.");
  demand_positive(sample);
  const Random random = seeded(seed);
  std::vector<double> dealt = sample;
  if (dealt.size() % 2 == 1) dealt.erase(dealt.begin() + static_cast<long>(dealt.size() / 2));
  const auto half = dealt.begin() + static_cast<long>(dealt.size() / 2);
  // Enough that the quantile moves by less than a tenth of itself with another seed.
  constexpr int kSplits = 2000;
  std::vector<double> apart;
  for (int k = 0; k < kSplits; ++k) {
    gsl_ran_shuffle(random.get(), dealt.data(), dealt.size(), sizeof(double));
    apart.push_back(
        std::abs(std::log(median({dealt.begin(), half}) / median({half, dealt.end()}))));
  }
  std::sort(apart.begin(), apart.end());
  const auto at = static_cast<std::size_t>(level * (kSplits - 1));
  return apart[at] / std::numbers::sqrt2;
}

}  // namespace stiction::reference
