// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace stiction::reference {

/// Two elastic bodies that touch at a point, pressed together without friction [Hertz 1882,
/// textbook form]:  a³ = 3FR/(4E*),  δ = a²/R.
struct HertzContact {
  double patch = 0.0;     ///< a, radius of the flat patch, m
  double approach = 0.0;  ///< δ, by how much the bodies' far ends come nearer, m
};

/// `force` F in N; `radius` R in m: 1/R = 1/R₁ + 1/R₂; `modulus` E* in Pa:
/// 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂.
HertzContact hertz_contact(double force, double radius, double modulus);

/// Three balls of radius r that just touch, one of radius `ratio` · r of the same stuff on them.
struct SoftFourBalls {
  double radius = 0.1;          ///< r, m
  double ratio = 1.75;          ///< R/r
  double density = 1000.0;      ///< kg/m³
  double youngs_modulus = 1e6;  ///< Pa
  double poisson_ratio = 0.3;   ///< dimensionless
  double gravity = 9.81;        ///< m/s²
};

/// Least μ between smooth soft balls, first order in the flattening: as for rigid ones
/// (limit_scenes.h), μ = tan(θ/2), but the centres are nearer by Hertz' δ: sin θ = (2/√3)/(1 + R/r
/// − δ/r). The normal force between two balls is a third of the top one's weight, whatever μ is:
/// the resultant makes the same angle θ/2 with the line of centres as with the vertical. Flattening
/// on the ground lowers all balls alike and changes nothing.
struct SoftFourBallThreshold {
  double friction = 0.0;
  HertzContact between;  ///< of a lower ball and the top one
  HertzContact ground;
};
SoftFourBallThreshold soft_four_ball_threshold(const SoftFourBalls& balls);

}  // namespace stiction::reference
