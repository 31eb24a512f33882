// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "solver/friction/rule.h"

namespace stiction {

/// Static friction made coherent over time by a fixed-point iteration, one update a step
/// [Lazarevych2009, (14)–(18)]: one value ξ a contact, an integral controller on the slip left.
///
///   ξ ← ξ + g (u·ũ)/|ũ|²      if the contact stuck in the last step
///   stick   f = ξ λ f_max = −ξ ũ/w, clamped to |f| ≤ μ fⁿ
///   slip    f = f_max
///
/// Deviations from the paper:
/// 1. The gain g is dimensionless: g = −α|ũ|. The paper's α carries s/m and its printed −0.1 does
///    almost nothing in SI units; `alpha` restores it.
/// 2. Initial ξ = 1; ξ is forgotten when the contact separates, and when it slips unless
///    `memory` is kept (the paper says nothing of either).
/// 3. A clamped contact slips, and a slipping one does not learn, so the controller cannot wind up.
/// 4. The slip u (start of the step) is projected on ũ/|ũ| of the present step. With |ũ| ≤ 1e-12
///    m/s (1e-8 in single precision) that direction is round-off: ξ is held, the closed form needs no direction.
///
/// u → 0: ξ is constant. A fixed obstacle leaves u = 0, so ξ stays 1.
struct FixedPoint {
  static constexpr RuleCard kCard{"ξ",
                                  "inside the cone; removes slip along ũ where the loop gain is "
                                  "below 2; blind to slip across ũ"};
  static constexpr bool kWarmStart = false;
  static constexpr int kValues = 1;
  static constexpr Real kDirectionLess = by_precision(1e-12, 1e-8);  ///< m/s

  /// The paper's raw α [(16)–(18)]: ξ ← ξ − α u.
  static constexpr RuleParameter kAlpha{.name = "alpha",
                                        .help = "the paper's raw α, in place of g",
                                        .unit = "s/m",
                                        .told_when_set = true,
                                        .replaces = "gain"};
  static constexpr std::array kParameters{parameter::kGain, kAlpha, parameter::kMemory};

  explicit FixedPoint(const RuleSettings& given)
      : gain_(value_of(parameter::kGain, given)),
        raw_alpha_(value_of(kAlpha, given)),
        keep_through_slip_(is_on(parameter::kMemory, given)) {}

  void reset(Real* memory) const { memory[0] = 1.0; }

  SlipSolution solve(const SlipProblem& problem, Real* memory) const {
    Real& xi = memory[0];
    const Real free_slip = problem.free_slip.norm();
    if (problem.first_sweep && problem.was == ContactStatus::kStick && free_slip > kDirectionLess) {
      const Real slip = problem.start_slip.dot(problem.free_slip) / free_slip;
      xi += raw_alpha_ != 0.0 ? -raw_alpha_ * slip : gain_ * slip / free_slip;
    }
    if (!can_stick(problem)) return slipped(problem, xi);
    const Vec3 force = -xi / problem.inverse_mass * problem.free_slip;
    if (force.squaredNorm() > problem.bound * problem.bound) return slipped(problem, xi);
    return {force, ContactStatus::kStick};
  }

 private:
  SlipSolution slipped(const SlipProblem& problem, Real& xi) const {
    if (!keep_through_slip_) xi = 1.0;
    return sliding(problem);
  }

  Real gain_;
  Real raw_alpha_;
  bool keep_through_slip_;
};

}  // namespace stiction
