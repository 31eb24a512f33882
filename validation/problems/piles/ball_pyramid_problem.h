// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "reference/limit/limit_analysis.h"
#include "reference/motion/soft_balls.h"
#include "validation/engine/engine.h"
#include "validation/engine/problem.h"

namespace stiction {

/// The paper's Fig. 7: three balls of radius r that just touch each other on level ground, and a
/// larger one of the same density in the hollow between them. Bodies 0–2 are the lower balls, 3 the
/// top one; obstacle 0 is the ground.
struct BallPyramidSetup {
  double friction = 0.24;   ///< μ everywhere
  double radius = 0.1;      ///< r, m
  double ratio = 1.75;      ///< R/r: gives the two thresholds that the paper prints
  int frequency = 8;        ///< n of the engine's triangulation (its setting `ball`)
  double density = 1000.0;  ///< kg/m³
  Elasticity elasticity{.youngs_modulus = 1e6, .poisson_ratio = 0.3, .damping_time = 1e-4};
  double full_load = 0.3;  ///< gravity has ramped from 0 to full, s
  /// While it settles: the top ball bounces on the lower ones at about 40 rad/s, which strain-rate
  /// damping alone would take seconds to end.
  Drag drag{.rate = 30.0, .full_until = 0.7, .ends = 0.9};
};

inline constexpr std::size_t kLowerBalls = 3;
inline constexpr std::size_t kTopBall = 3;

/// Smooth balls in exact contact: a triangulated ball lies inside its sphere, so nothing overlaps.
/// All balls stand on a facet, turned by 120° from one another, so that the scene has the threefold
/// symmetry of the smooth one.
Problem ball_pyramid_problem(const BallPyramidSetup& setup);

/// Where the pyramid has got to.
struct PyramidShape {
  double top_height = 0.0;  ///< of the top ball's centre, m
  double rise = 0.0;        ///< of that above the mean of the lower balls' centres, m
  double spread = 0.0;      ///< mean distance of the lower balls' centres from the axis, m
  double speed = 0.0;       ///< mean outward speed of the lower balls' centres, m/s

  /// What smooth rigid balls with centres there need between each other: tan(θ/2), θ the angle of
  /// the line of centres with the vertical.
  double critical_friction() const { return std::tan(0.5 * std::atan2(spread, rise)); }
};
PyramidShape pyramid_shape(const Engine& engine);

/// What the contacts of `limit_problem` may carry.
enum class ContactLoads {
  /// Each any load: rest with less μ than the answer is impossible, above it elasticity decides.
  kAny,
  /// Each the normal force that it has: the answer is what the pressures of these soft bodies need,
  /// rolling resistance and all. What still swings is out of balance, by 1e-3 of the weight where a
  /// mean over a second changes by 0.01 m/s, so ask with `kMovingResidual`.
  kMeasured
};

inline constexpr double kMovingResidual = 9e-4;  ///< of the whole weight, LimitOptions::residual

/// The rigid problem of those `contacts` that carry a load. (One contact point a pair, at the
/// resultant, gives no reference: 18 forces for 24 equations.)
reference::LimitProblem limit_problem(const Engine& engine, const BallPyramidSetup& setup,
                                      const std::vector<ContactSample>& contacts,
                                      ContactLoads loads);

/// The least μ that the scene's smooth soft balls need between each other (soft_balls.h).
reference::SoftFourBallThreshold smooth_threshold(const BallPyramidSetup& setup);

}  // namespace stiction
