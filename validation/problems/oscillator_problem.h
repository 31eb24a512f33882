// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/problem.h"

namespace stiction {

/// A box on level ground on a spring along the ground, through its centre. With ω = √(k/m) and
/// δ = μ m g/k:
///
/// - The anchor is drawn away at V, which is a belt seen by who rides on it. The box sticks until
///   t₁ = δ/V; then, with τ = t − t₁,  x = V τ − (V/ω) sin ω τ: it comes to rest at ω τ = 2π, with
///   the spring at δ again, and goes on without a stick. One μ: no self-excited vibration.
/// - The anchor rests and the box starts `stretch` δ away from it. Friction moves the middle of each
///   half-swing by δ against the motion, so the turning points are stretch − 2, stretch − 4, … δ, on
///   either side in turn, and it stays at the first one that is no farther than δ.
struct OscillatorSetup {
  double mass = 1.0;          ///< m, kg
  double friction = 0.3;      ///< μ
  double stiffness = 100.0;   ///< k, N/m
  double drawn = 0.0;         ///< V, m/s
  double stretch = 0.0;       ///< of the spring at the start, δ
  double azimuth = 0.5236;    ///< of the spring, rad
  Vec3 size{0.2, 0.2, 0.05};  ///< m
  /// So stiff that the box's own shear, μ m g h/(2 G A), is 1e-4 δ at most; without lateral strain, for
  /// which friction across the spring would be left from when the box was set down.
  Elasticity elasticity{.youngs_modulus = 5e6, .poisson_ratio = 0.0, .damping_time = 3e-4};
};

/// Bodies: the box, whose centre starts above the origin.
Problem oscillator_problem(const OscillatorSetup& setup);

Vec3 oscillator_axis(const OscillatorSetup& setup);      ///< away from the anchor, unit length
double oscillator_rate(const OscillatorSetup& setup);    ///< ω, 1/s
double oscillator_offset(const OscillatorSetup& setup);  ///< δ, m

}  // namespace stiction
