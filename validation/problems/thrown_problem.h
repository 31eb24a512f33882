// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/problem.h"

namespace stiction {

/// A ball, or a box flat, flies at level ground and meets it obliquely. There is no gravity, so
/// that what the impact leaves stays. With P the impulse of the ground, p = P/m, where friction
/// slides throughout:
///
///   v_t' = v_t − μ p,   ball: ω r = 5/2 μ p,   box: ω = 0 while μ h < w
///
/// and p = v_n for a rigid body without restitution. A ball sticks where v_t < 7/2 μ v_n:
/// v_t' = 5/7 v_t, ω r = v_t'.
struct ThrownSetup {
  bool ball = true;         ///< else a box
  double size = 0.1;        ///< radius r of the ball, or width w of the box, m
  double height = 0.05;     ///< h of the box, m
  double mass = 4.0;        ///< kg
  double friction = 0.3;    ///< μ
  double approach = 1.0;    ///< v_n, m/s
  double along = 10.0;      ///< v_t, m/s
  double azimuth = 0.5236;  ///< of v_t, rad: along no engine's friction pyramid
  double yaw = 0.3;         ///< of the body about the vertical, rad
  double gap = 0.01;        ///< m, at the start
  Elasticity elasticity{.youngs_modulus = 1e6, .poisson_ratio = 0.3, .damping_time = 1e-3};
};

/// Bodies: the one that is thrown.
Problem thrown_problem(const ThrownSetup& setup);

/// Of v_t, unit length.
Vec3 thrown_along(const ThrownSetup& setup);

}  // namespace stiction
