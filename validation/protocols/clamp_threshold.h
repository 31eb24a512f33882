// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/problems/clamp_problem.h"

namespace stiction {

/// Least force of a clamp, against the exact limit analysis of its rigid geometry (clamp_limit.h):
/// known before anything is simulated, N = n m g/(2(μ − Δh/w)) where two rows of points touch.
///
/// The analysis is of rigid bodies. What elasticity adds (the clamp presses the boxes narrower,
/// which lengthens the lever of the offset, and they turn under the couple) falls with 1/E, so that
/// the search is done at E, 4 E and 16 E and extrapolated. Checked are the force, that the clamp
/// that holds is at rest after twice the time, and with `half_step` that half the time step finds
/// the same force, at 16 E, or at E where the rigid limit is far.
/// `most` and `least` bracket the jaws' way at E, m; `width` is where the search ends.
void check_clamp_threshold(CaseRun& run, const ClampSetup& setup, double most, double least,
                           double width, bool half_step = false);

}  // namespace stiction
