// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "validation/engine/problem.h"

namespace stiction {

inline constexpr double kStandardGravity = 9.81;  ///< m/s², as in the peers' figures

/// By how much what slides accelerates more for each unit of tan θ, next to tan θ = μ: the derivative of
/// g (sin θ − μ cos θ), m/s².
inline double acceleration_by_slope(double friction) {
  return kStandardGravity / std::hypot(1.0, friction);
}

/// The flat box of the incline family: 0.2 × 0.2 × 0.1 m, 1 kg. It topples only at
/// tan θ = width/height = 2, far above every μ used.
struct InclineSetup {
  double tan_slope = 0.0;  ///< tan θ
  double friction = 0.5;   ///< μ
  double azimuth = 0.0;    ///< direction in which the slope falls, rad from x about z
  double yaw = 0.0;        ///< of the box about the plane's normal, rad
  Shape shape = BoxShape{{0.2, 0.2, 0.1}};
  double mass = 1.0;         ///< kg
  bool must_deform = false;  ///< what is claimed is not true of a rigid body
  Elasticity elasticity{.youngs_modulus = 5e5, .poisson_ratio = 0.3, .damping_time = 1e-3};
  double speed = 0.0;     ///< downhill at t = 0, m/s
  double duration = 1.0;  ///< s
};

/// Directions of a slope, unit vectors.
struct InclineFrame {
  Vec3 normal;    ///< out of the plane
  Vec3 downhill;  ///< steepest descent; along the azimuth when level
};

InclineFrame incline_frame(const InclineSetup& setup);

/// A body lying on a fixed plane under constant full gravity from t = 0.
Problem incline_problem(const InclineSetup& setup);

/// Times of a body that is settled before the load is measured, s.
struct SettledLoad {
  double normal_full = 0.2;      ///< the part of gravity into the plane has grown from 0 to full
  double tangential_from = 0.3;  ///< the downhill part starts to grow
  double tangential_full = 0.7;  ///< … and is full
};

/// The same body and plane, but gravity arrives in two smooth ramps: first into the plane, so that
/// the body settles without shear, then along it. The load path has no jump to start a slip.
Problem settled_incline_problem(const InclineSetup& setup, const SettledLoad& load = {});

}  // namespace stiction
