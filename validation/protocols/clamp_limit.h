// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/limit/limit_analysis.h"
#include "validation/problems/clamp_problem.h"

namespace stiction {

/// The points at which the rigid bodies of a clamp touch before anything is pressed: vertices of
/// either mesh on the face of its neighbour, edges included, and the corners of the faces' overlap.
/// Geometry alone, no solver. The jaws' normal forces add up to `force`, N; gravity is the live
/// load.
reference::LimitProblem clamp_points(const ClampSetup& setup, double force);

/// Exact bracket of the least force that holds rigid boxes, N: limit analysis of `clamp_points`.
/// Necessary for rest; a real clamp may need more (limit_analysis.h).
struct ClampLimit {
  double lower = 0.0, upper = 0.0;
};
ClampLimit clamp_limit(const ClampSetup& setup);

}  // namespace stiction
