// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "validation/core/case_run.h"

namespace stiction {

/// The methods that every two-sided case sets side by side: old (what the paper compares itself
/// with), paper with the fixed-point and with the secant iteration, and quiet. Of old, only what
/// the engine's table expects is judged: that it breaks where the paper says so.
inline std::vector<Settings> method_variants() {
  return {{{"method", "old"}},
          {{"method", "paper"}},
          {{"method", "paper"}, {"rule", "secant"}},
          {{"method", "quiet"}}};
}

/// Whether the run is of the paper's method. Where a case lets bodies part, as a search for a
/// threshold does, or throws them together, they pass through each other with it: there that is
/// noted, and no error of the run.
inline bool is_paper(const CaseRun& run) {
  const auto method = run.settings().find("method");
  return method != run.settings().end() && method->second == "paper";
}

}  // namespace stiction
