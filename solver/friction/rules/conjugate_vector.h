// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <type_traits>

#include "solver/friction/rules/stored_vector.h"

namespace stiction {

/// Nonsmooth nonlinear conjugate gradient [Silcowitz2010]: the stored vector whose sweeps
/// (iterations over all contacts) are accelerated by conjugate directions of all together. With r
/// the change of all forces by a sweep, |r|² = Σ w rᵢ²,
///
///   β = |rᵏ|²/|rᵏ⁻¹|²;   β > 1: p ← r,   else   f ← P(f + β p),  p ← β p + r
///
/// after each sweep but the last, which is the one that takes away no more slip than
/// `slip-tolerance` gΔt, or the `sweeps`th, or one after which sweeps hardly help any more: at rest
/// one sweep does. Contacts of both sides that say nearly the same twice make a sweep pass slip to
/// and fro; conjugate directions see the pattern. With one sweep it is the stored vector.
///
/// Deviation: the accelerated force is clamped to the cone at once, because a sweep that takes a
/// clamped contact for a sticking one would move its neighbours.
struct ConjugateVector : StoredVector {
  static constexpr RuleCard kCard{
      "f",
      "inside the cone; as the stored vector, restarted where the residual grows; needs two sweeps "
      "or more to differ from it",
      64};
  static constexpr bool kConjugate = true;
  /// In gΔt (Gravity::scale), the slip that a step of free fall gives. A millionth of it is far
  /// below what vibration leaves while anything moves, and reached by one sweep once nothing does.
  /// In single precision a velocity of gΔt has its last digit at 1.2e-7 gΔt, and the slip of a
  /// two-sided contact is made of four: 1e-6 is twice what they sum to. With 1e-7, which rounding
  /// never lets it reach, a box at rest took eight sweeps a step.
  static constexpr RuleParameter kSlipTolerance{
      .name = "slip-tolerance",
      .help = "the slip whose removal ends a step's sweeps, in gΔt",
      .initial = std::is_same_v<Real, double> ? 1e-7 : 1e-6,
      .low = 0.0};
  static constexpr std::array kParameters{kRelaxation, kSlipTolerance};

  explicit ConjugateVector(const RuleSettings& given)
      : StoredVector(given), slip_tolerance_(value_of(kSlipTolerance, given)) {}

  /// A sweep that takes away no more slip than this from any contact is the last, in gΔt.
  Real slip_tolerance() const { return slip_tolerance_; }

 private:
  Real slip_tolerance_;
};

}  // namespace stiction
