// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "validation/engine.h"

namespace stiction {

/// The methods that every two-sided case sets side by side: old (what the paper compares itself
/// with), paper with the fixed-point and with the secant iteration, and quiet. Checks of old are
/// shown and decide nothing.
inline std::vector<Settings> method_variants() {
  return {{{"method", "old"}},
          {{"method", "paper"}},
          {{"method", "paper"}, {"rule", "secant"}},
          {{"method", "quiet"}}};
}

}  // namespace stiction
