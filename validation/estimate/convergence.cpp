// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/estimate/convergence.h"

#include <cmath>
#include <limits>

#include "solver/demand.h"

namespace stiction {

double observed_order(const std::vector<double>& step_size, const std::vector<double>& error) {
  demand(step_size.size() == error.size() && error.size() >= 3, "an order needs three points");
  const auto n = static_cast<double>(error.size());
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t k = 0; k < error.size(); ++k) {
    if (error[k] == 0.0) return std::numeric_limits<double>::quiet_NaN();
    const double x = std::log(step_size[k]);
    const double y = std::log(std::abs(error[k]));
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace stiction
