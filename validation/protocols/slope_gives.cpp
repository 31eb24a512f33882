// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/slope_gives.h"

#include <cmath>

#include "validation/protocols/incline_run.h"

namespace stiction {

SlopeResponse slope_response(CaseRun& run, const InclineSetup& setup, const Accuracy& accuracy) {
  constexpr double kFrom = 1.0, kWindow = 0.5;  // s; the load is full at 0.7 s
  InclineRun incline(run, setup, settled_incline_problem(setup), accuracy);
  incline.advance_to(kFrom);
  const double start = incline.time(), first = incline.travel();
  incline.advance_to(kFrom + kWindow);
  const double middle = incline.time(), second = incline.travel();
  incline.advance_to(kFrom + 2.0 * kWindow);
  const double end = incline.time(), third = incline.travel();
  const double slow = (second - first) / (middle - start);
  const double fast = (third - second) / (end - middle);
  const double acceleration = (fast - slow) / (0.5 * (end - start));
  const double free = kStandardGravity * std::sin(std::atan(setup.tan_slope));
  const double excess = acceleration - kGiving * free;
  return {fast, acceleration, excess, !(excess < 0.0)};
}

Bracket slope_that_gives(CaseRun& run, const InclineSetup& setup, double width,
                         const Accuracy& accuracy) {
  const auto holds = [&](double tan_slope) {
    InclineSetup sloped = setup;
    sloped.tan_slope = tan_slope;
    const SlopeResponse response = slope_response(run, sloped, accuracy);
    return Holding(!response.gives, response.excess);
  };
  const double expected = giving_slope(setup.friction);
  // Begun so that no slope tried is Coulomb's own, where it gives: by how much leads to a right answer in
  // two more runs.
  const double guess = expected + 3.7 * width;
  const Bracket near = find_threshold_near(guess, width, 0.98 * guess, width, holds,
                                           acceleration_by_slope(setup.friction));
  if (!std::isnan(near.holds)) return near;
  Bracket far = find_threshold(0.02 * guess, 3.0 * guess, width, holds);
  far.evaluations += near.evaluations;
  return far;
}

}  // namespace stiction
