// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/incline_threshold.h"

#include <cmath>

#include "validation/incline_run.h"

namespace stiction {

bool incline_holds(CaseRun& run, const InclineSetup& setup, const Settings& extra) {
  constexpr double kAtRest = 1e-9;  // m/s: far above round-off, far below any start-up slip
  InclineRun incline(run, setup, settled_incline_problem(setup), extra);
  incline.advance_to(1.1);
  const double before = incline.speed();
  incline.advance_to(1.4);
  const double after = incline.speed();
  return std::abs(after) < kAtRest || after < before;
}

Bracket incline_threshold(CaseRun& run, const InclineSetup& setup, double width,
                          const Settings& extra) {
  return find_threshold(0.83 * setup.friction, 1.21 * setup.friction, width, [&](double tan_slope) {
    InclineSetup sloped = setup;
    sloped.tan_slope = tan_slope;
    return incline_holds(run, sloped, extra);
  });
}

}  // namespace stiction
