// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/problem.h"

namespace stiction {

/// A flat box of square face lies on level ground and is turned by a couple τ about the vertical.
///
///   it is held iff τ ≤ min over c of Σ μ N |p − c|, over its contacts' places p and normal forces N
///
/// That depends on where it presses: not at all if all pressure is at one point, 0.3826 μ m g a
/// if it is uniform, and at most μ m g a/√2, on the corners alone.
struct TurnedBoxSetup {
  double face = 0.2;      ///< a, m
  double height = 0.1;    ///< m
  double mass = 1.0;      ///< kg
  double friction = 0.5;  ///< μ
  double couple = 0.0;    ///< τ, N m
  double yaw = 0.35;      ///< of the box at the start, rad
  Elasticity elasticity{.youngs_modulus = 1e6, .poisson_ratio = 0.0, .damping_time = 1e-3};
};

/// When gravity is full; when the couple begins to grow and is full, s.
inline constexpr double kTurnWeighs = 0.2, kTurnFrom = 0.3, kTurnFull = 0.6;

/// Bodies: the box.
Problem turned_box_problem(const TurnedBoxSetup& setup);

/// μ m g a/√2, N m.
double most_couple(const TurnedBoxSetup& setup);

}  // namespace stiction
