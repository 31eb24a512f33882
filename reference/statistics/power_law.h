// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace stiction::reference {

/// y = factor · x^exponent, fitted to logarithms by least squares.
struct PowerLaw {
  double exponent = 0.0;
  double factor = 0.0;
  /// Half of the exponent's 95 % confidence interval (Student's t); infinite for two points.
  double exponent_margin = 0.0;
};

/// By GSL's linear fit. Throws std::invalid_argument unless x and y have the same size, at least
/// two points of different x, and all are positive and finite.
PowerLaw fit_power_law(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace stiction::reference
