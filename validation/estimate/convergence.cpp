// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/estimate/convergence.h"

#include <cmath>
#include <limits>

#include "reference/statistics/power_law.h"
#include "solver/demand.h"

namespace stiction {

double observed_order(const std::vector<double>& step_size, const std::vector<double>& error) {
  demand(step_size.size() == error.size() && error.size() >= 3, "an order needs three points");
  std::vector<double> size;
  for (const double one : error) {
    if (one == 0.0 || !std::isfinite(one)) return std::numeric_limits<double>::quiet_NaN();
    size.push_back(std::abs(one));
  }
  return reference::fit_power_law(step_size, size).exponent;
}

}  // namespace stiction
