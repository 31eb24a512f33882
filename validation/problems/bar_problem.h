// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/problem.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

/// A long elastic bar of square section on a rigid bed, along x. Its end at x = 0 is held, and pushed
/// along by U, back to 0, and again; each stroke is a ramp and a hold. Poisson's ratio is 0. U is such
/// that friction τ = μ ρ g A per length lets a one-dimensional bar slide over `slip_length`:
///
///   a = √(2 E A U/τ),   F = τ a.
struct BarSetup {
  double length = 1.0, side = 0.0125;      ///< m
  double modulus = 5e5, density = 1000.0;  ///< Pa, kg/m³
  double friction = 0.5;                   ///< μ
  double slip_length = 0.5;                ///< a, m
  double damping_time = 2e-4;              ///< β, s
  double settled = 0.2;                    ///< when the first stroke begins, s
  double ramp = 0.6, hold = 0.2;           ///< of a stroke, s
};

constexpr double bar_stiffness(const BarSetup& bar) {  ///< EA, N
  return bar.modulus * bar.side * bar.side;
}
constexpr double bar_traction(const BarSetup& bar) {  ///< τ, N/m
  return bar.friction * bar.density * kStandardGravity * bar.side * bar.side;
}
constexpr double bar_push(const BarSetup& bar) {  ///< U, m
  return bar_traction(bar) * bar.slip_length * bar.slip_length / (2.0 * bar_stiffness(bar));
}
constexpr double bar_turn(const BarSetup& bar) { return bar.ramp + bar.hold; }  ///< of a stroke, s

/// Bodies: the bar.
Problem bar_problem(const BarSetup& setup);

}  // namespace stiction
