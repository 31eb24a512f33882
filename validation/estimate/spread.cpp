// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/estimate/spread.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/statistics/two_samples.h"

namespace stiction {

Spread spread(std::vector<double> values) {
  if (values.empty()) return {};
  for (double& value : values) {
    if (std::isnan(value)) value = std::numeric_limits<double>::infinity();
  }
  Spread result;
  const auto worst = std::max_element(values.begin(), values.end());
  result.worst = *worst;
  result.worst_at = static_cast<std::size_t>(worst - values.begin());
  result.median = reference::median(std::move(values));
  return result;
}

std::string spread_words(const Spread& spread, const std::string& unit) {
  return fmt::format("median {:.1e} {}, worst {:.1e} {}", spread.median, unit, spread.worst, unit);
}

}  // namespace stiction
