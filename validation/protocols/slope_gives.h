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

/// Whether a body gives on this slope: the gain between its mean speeds of two half seconds, after
/// the load has come smoothly.
bool gives(CaseRun& run, const InclineSetup& setup, const Accuracy& accuracy = {});

/// The tan θ at which it does, in a bracket of this width, wherever it may lie between level ground
/// and three times the critical slope. `setup.tan_slope` has no effect.
Bracket slope_that_gives(CaseRun& run, const InclineSetup& setup, double width,
                         const Accuracy& accuracy = {});

}  // namespace stiction
