// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/incline_threshold.h"

#include <cmath>
#include <limits>

#include "validation/protocols/incline_run.h"

namespace stiction {

namespace {

constexpr double kFrom = 1.1, kWatched = 0.3;  // s

}  // namespace

Holding incline_holds(CaseRun& run, const InclineSetup& setup, const Accuracy& accuracy) {
  constexpr double kAtRest = 1e-9;  // m/s: far above round-off, far below any start-up slip
  InclineRun incline(run, setup, settled_incline_problem(setup), accuracy);
  incline.advance_to(kFrom);
  const double before = incline.speed();
  incline.advance_to(kFrom + kWatched);
  const double after = incline.speed();
  return {std::abs(after) < kAtRest || after < before, after - before};
}

Bracket incline_threshold(CaseRun& run, const InclineSetup& setup, double width,
                          const Accuracy& accuracy) {
  const auto holds = [&](double tan_slope) {
    InclineSetup sloped = setup;
    sloped.tan_slope = tan_slope;
    return incline_holds(run, sloped, accuracy);
  };
  // Far from Coulomb's value as theory has it, so that the search about that is about the only one.
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!holds(0.83 * setup.friction).holds || holds(1.21 * setup.friction).holds)
    return {kNone, kNone, 2};
  // Begun so that no slope tried is Coulomb's own.
  Bracket near =
      find_threshold_near(setup.friction + 3.7 * width, 8.0 * width, 0.17 * setup.friction, width,
                          holds, kWatched * acceleration_by_slope(setup.friction));
  near.evaluations += 2;
  return near;
}

}  // namespace stiction
