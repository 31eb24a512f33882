// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/estimate/extrapolation.h"

#include <cmath>
#include <limits>

#include "solver/demand.h"

namespace stiction {

Extrapolation extrapolate(double coarse, double medium, double fine, double ratio) {
  demand(ratio > 1.0, "refinement is by a factor above 1");
  const double quotient = (coarse - medium) / (medium - fine);
  if (!(quotient > 1.0) || !std::isfinite(quotient)) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {kNone, kNone};
  }
  return {fine + (fine - medium) / (quotient - 1.0), std::log(quotient) / std::log(ratio)};
}

double extrapolate_with_order(double medium, double fine, double ratio, double order) {
  demand(ratio > 1.0 && order > 0.0, "refinement is by a factor above 1, the order is positive");
  return fine + (fine - medium) / (std::pow(ratio, order) - 1.0);
}

}  // namespace stiction
