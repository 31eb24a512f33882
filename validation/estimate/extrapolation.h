// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace stiction {

/// A quantity q(h) = q₀ + a hᵖ + …, measured at h, h/r and h/r² (h: mesh width, time step,
/// compliance 1/E), taken to h → 0.
struct Extrapolation {
  double limit = 0.0;  ///< q₀ with the order that the three values show
  double order = 0.0;  ///< p
};

/// Aitken's limit and the order behind it:
///   p = log((q₁ − q₂)/(q₂ − q₃))/log r,  q₀ = q₃ + (q₃ − q₂)/(rᵖ − 1).
/// Both are NaN where the values don't converge monotonically (the differences differ in sign, one
/// of them is zero, or they don't fall): then no check can pass on them. Needs `ratio` > 1.
Extrapolation extrapolate(double coarse, double medium, double fine, double ratio);

/// Richardson's limit from two values, with the order known beforehand: q₃ + (q₃ − q₂)/(rᵖ − 1).
double extrapolate_with_order(double medium, double fine, double ratio, double order);

}  // namespace stiction
