// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/core/case_run.h"
#include "validation/estimate/threshold.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

// When does a slope give? Not where a body moves: an engine that creeps moves on every slope. It
// gives where the body keeps gaining speed, by more than 10⁻³ of what it would without friction. By
// Coulomb's law that is where g(sin θ − μ cos θ) = 10⁻³ g sin θ, so nothing is biased by asking so.
inline constexpr double kGiving = 1e-3;

/// tan θ at which a body gives by Coulomb's law.
constexpr double giving_slope(double friction) { return friction / (1.0 - kGiving); }

/// What a body does on a slope, after the load has come smoothly.
struct SlopeResponse {
  double speed = 0.0;         ///< mean of the last half second, downhill, m/s
  double acceleration = 0.0;  ///< the gain between the mean speeds of two half seconds, m/s²
  double excess = 0.0;        ///< of the acceleration over that at which it gives, m/s²
  bool gives = false;         ///< also where that is no number: the engine has lost the body
};
SlopeResponse slope_response(CaseRun& run, const InclineSetup& setup,
                             const Accuracy& accuracy = {});

/// The tan θ at which it does, in a bracket of this width, wherever it may lie between level ground
/// and three times the critical slope. `setup.tan_slope` has no effect.
Bracket slope_that_gives(CaseRun& run, const InclineSetup& setup, double width,
                         const Accuracy& accuracy = {});

}  // namespace stiction
