// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "reference/statistics/two_samples.h"

namespace stiction::bench {

/// Quartiles of the seconds that `first()` gives over those of `second()`, called A B A B, at least so
/// many times and so long.
template <class First, class Second>
reference::Quartiles ratio_in_turn(const First& first, const Second& second) {
  constexpr std::size_t kFewest = 11;
  constexpr double kLeastSeconds = 0.1;
  std::vector<double> ratios;
  for (double spent = 0.0; ratios.size() < kFewest || spent < kLeastSeconds;) {
    const double one = first(), other = second();
    ratios.push_back(one / other);
    spent += one + other;
  }
  return reference::quartiles(std::move(ratios));
}

}  // namespace stiction::bench
