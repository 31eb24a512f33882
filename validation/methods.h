// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "validation/case_run.h"

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

/// The known limit of checks that ask for rest between bodies: the paper's method never has it, and
/// why is measured in slab/kappa. Empty for the other methods.
inline std::string no_rest_of_paper(const CaseRun& run) {
  const auto method = run.settings().find("method");
  if (method == run.settings().end() || method->second != "paper") return {};
  return "the paper's normal forces close up to 1.7 times a depth in a step (slab/kappa), so that "
         "light contacts leave and return for ever, and friction holds against a load that jumps";
}

}  // namespace stiction
