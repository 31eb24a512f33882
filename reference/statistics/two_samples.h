// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace stiction::reference {

/// Two-sided p-value of the exact Mann–Whitney U test [MannWhitney1947]: the share, over all ways
/// to deal the pooled values into groups of the two sizes, of those whose rank sum is as far from
/// its mean as the observed one or farther. Ties get mid-ranks and are exact too (the permutation
/// distribution given the ties). Dimensionless, in (0, 1]; 1 when all values are equal.
///
/// Exact to round-off up to 25 values each (the counts stay below 2⁵³); the cost grows with the
/// fourth power of the size. Throws std::invalid_argument for an empty sample or a NaN.
double mann_whitney_p(const std::vector<double>& a, const std::vector<double>& b);

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// Percentile bootstrap interval [Efron1979] of median(b) / median(a): both samples are drawn again
/// with replacement, `resamples` times, by GSL's Mersenne twister from `seed`; the same call gives
/// the same interval. `level` is the share inside, in (0, 1).
/// Throws std::invalid_argument for an empty sample or a value that is not positive and finite.
Interval bootstrap_median_ratio(const std::vector<double>& a, const std::vector<double>& b,
                                double level, int resamples, std::uint64_t seed);

/// The middle value, or the mean of the two in the middle. Throws std::invalid_argument when empty.
double median(std::vector<double> values);

struct Quartiles {
  double lower = 0.0, median = 0.0, upper = 0.0;
};

/// By linear interpolation between the sorted values. Throws as `median`.
Quartiles quartiles(std::vector<double> values);

/// How far apart the medians of two halves of one sample stand: |ln ratio|, of which `level` of all
/// balanced ways to halve it are not above; of an odd count the middle one in order is left out.
/// What a comparison of the sample with itself shows, so what no effect may be claimed below.
/// A half has fewer values than the sample, and its median scatters √2 more: the result is divided
/// by √2. Dimensionless. Throws std::invalid_argument below 4 values or for one that is not
/// positive.
double split_half_noise(const std::vector<double>& sample, double level, std::uint64_t seed);

}  // namespace stiction::reference
