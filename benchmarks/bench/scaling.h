// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/bench/measure.h"
#include "reference/statistics/power_law.h"

namespace stiction::bench {

/// How the cost of a part of the step grows with the contacts of a family.
struct Scaling {
  std::string family;
  std::string part;              ///< a timed part, or a sum of phases: "detect + depth"
  std::vector<double> contacts;  ///< increasing
  std::vector<double> seconds;   ///< of a batch, as many
  reference::PowerLaw law;       ///< seconds over contacts; exponent 1: linear
};

/// Of each family and part that was measured at three sizes or more: the parts, and then the sums
/// that the targets speak of, "detect + depth" and "normal-force + friction" by the usual rule.
std::vector<Scaling> scalings(const std::vector<Result>& results);

}  // namespace stiction::bench
