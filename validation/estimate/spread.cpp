// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/estimate/spread.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
  const std::size_t middle = values.size() / 2;
  std::sort(values.begin(), values.end());
  result.median =
      values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
  return result;
}

std::string spread_words(const Spread& spread, const std::string& unit) {
  return fmt::format("median {:.1e} {}, worst {:.1e} {}", spread.median, unit, spread.worst, unit);
}

}  // namespace stiction
