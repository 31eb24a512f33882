// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stiction {

/// Of several runs of one claim (seeds, poses, windows, steps): the middle one and the worst.
struct Spread {
  double median = 0.0;
  double worst = 0.0;        ///< the largest
  std::size_t worst_at = 0;  ///< its index
};

/// NaN counts as infinite; no values: all zero.
Spread spread(std::vector<double> values);

template <class Outcome, class Value>
Spread spread_of(const std::vector<Outcome>& outcomes, Value value) {
  std::vector<double> values;
  for (const Outcome& outcome : outcomes) values.push_back(value(outcome));
  return spread(values);
}

/// "median 1e-9 m, worst 3e-7 m".
std::string spread_words(const Spread& spread, const std::string& unit);

}  // namespace stiction
