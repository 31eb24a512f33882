// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace stiction {

/// Observed order of convergence from errors at three or more step sizes: the slope of log |error|
/// over log h by least squares. NaN when an error is zero or not finite.
double observed_order(const std::vector<double>& step_size, const std::vector<double>& error);

}  // namespace stiction
