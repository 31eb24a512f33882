// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/problem.h"

namespace stiction {

/// A small box held by friction between two jaws: boxes that stand on a floor without friction and
/// are pushed towards each other, along x, by a force each. Gravity grows so slowly that nothing
/// bounces; a load carries the body until the jaws are closed, then lets it go.
///
///   the body holds iff 2 μ F ≥ m g; else it falls at a = g − 2 μ F/m
///
/// On a floor without friction two forces that point at each other would turn everything about the
/// vertical, at √(F L/J) = 3 1/s, L apart and J the inertia. So a spring across the forces holds the
/// centre of each jaw, sixty times as stiff as the 2 F/L that this takes; at rest it is slack.
///
/// The jaws do not tilt. Body and jaws have their centres at one height, so that force and counterforce
/// have no couple; the friction m g/2 at a jaw's inner face moves the floor's reaction by
/// s = w m/(4 M + 2 m) inwards (w its width, M its mass), 0.4 mm of the 40 mm to its edge, and a
/// body that has fallen by d another F d/(M g).
struct PinchSetup {
  double force = 0.5;          ///< F, N
  double friction = 0.7;       ///< μ between body and jaws
  double mass = 0.045;         ///< m of the body, kg
  double edge = 0.02;          ///< of the body, a cube, m
  double jaw_mass = 2.0;       ///< M, kg
  Vec3 jaw{0.08, 0.06, 0.08};  ///< size of a jaw, m
  double azimuth = 0.0;        ///< all turned about the vertical, rad
  double guide = 1000.0;       ///< stiffness of the springs, N/m
  double settled = 0.5;        ///< until then a medium damps all motion, s
  /// So stiff that the jaws, which lean on elastic feet, lean by 3e-5 rad.
  Elasticity elasticity{.youngs_modulus = 5e7, .poisson_ratio = 0.3, .damping_time = 2e-5};
};

/// When gravity is full; when the jaws begin to press and press in full; when the body is let go,
/// and is free, s.
inline constexpr double kPinchWeighs = 0.15;
inline constexpr double kPinchFrom = 0.2, kPinchClosed = 0.4;
inline constexpr double kPinchLetGo = 0.5, kPinchFree = 0.7;

/// Bodies: the small box, then the jaws.
Problem pinch_problem(const PinchSetup& setup);

/// From the left jaw to the right one, unit length.
Vec3 pinch_across(const PinchSetup& setup);

/// m g/(2μ), N.
double least_pinch(const PinchSetup& setup);

}  // namespace stiction
