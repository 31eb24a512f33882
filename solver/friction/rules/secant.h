// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/friction/rule.h"

namespace stiction {

/// Static friction by the secant iteration, one update a step [Lazarevych2009, (19)]: three values
/// a contact (ξ, its predecessor, and the slip that belonged to it).
///
///   ξᵏ⁺¹ = ξᵏ − uᵏ (ξᵏ − ξᵏ⁻¹)/(uᵏ − uᵏ⁻¹)
///   stick   f = −ξ ũ/w, clamped to |f| ≤ μ fⁿ;   slip   f = f_max
///
/// Deviations from the paper:
/// 1. u is the slip over |ũ|, dimensionless, so that ξ and u change on the same scale.
/// 2. With `safeguard`: where |Δu| ≤ 1e-9 or Δξ = 0 (the formula divides by nothing), or the slope
///    has the wrong sign (more friction must mean less slip), the fixed-point step with the gain g
///    is taken instead, and |Δξ| ≤ ½. Without it a vanishing |Δu| can freeze ξ for good.
/// 3. Initial ξ = 1; forgotten on separation, and on slip unless `memory` is kept.
struct Secant {
  static constexpr RuleCard kCard{
      "ξ, ξ of the step before and its slip",
      "inside the cone; with the safeguard no step beyond ½; no convergence proven where contacts "
      "couple; blind to slip across ũ"};
  static constexpr bool kWarmStart = false;
  static constexpr int kValues = 3;  // ξ, ξ of the step before, u that came of it (NaN: none yet)

  static constexpr RuleParameter kSafeguard{
      .name = "safeguard",
      .help = "the fixed point's step where the slope misleads",
      .initial = 1.0,
      .off = "off",
      .on = "on"};
  static constexpr std::array kParameters{parameter::kGain, parameter::kMemory, kSafeguard};

  explicit Secant(const RuleSettings& given)
      : gain_(value_of(parameter::kGain, given)),
        keep_through_slip_(is_on(parameter::kMemory, given)),
        safeguard_(is_on(kSafeguard, given)) {}

  void reset(Real* memory) const {
    memory[0] = 1.0;
    memory[1] = 1.0;
    memory[2] = std::nan("");
  }

  SlipSolution solve(const SlipProblem& problem, Real* memory) const {
    const Real free_slip = problem.free_slip.norm();
    if (problem.first_sweep && problem.was == ContactStatus::kStick && free_slip > kDirectionLess) {
      update(problem.start_slip.dot(problem.free_slip) / (free_slip * free_slip), memory);
    }
    const Vec3 force = -memory[0] / problem.inverse_mass * problem.free_slip;
    if (!can_stick(problem) || force.squaredNorm() > problem.bound * problem.bound) {
      if (!keep_through_slip_) reset(memory);
      return sliding(problem);
    }
    return {force, ContactStatus::kStick};
  }

 private:
  static constexpr Real kDirectionLess = by_precision(1e-12, 1e-8);  // m/s, as in the fixed point
  static constexpr Real kFlat = by_precision(1e-9, 1e-5);
  static constexpr Real kLargestStep = 0.5;

  void update(Real slip, Real* memory) const {
    const Real xi = memory[0];
    const Real change_of_xi = xi - memory[1];
    const bool first = std::isnan(memory[2]);
    const Real change_of_slip = first ? 0 : slip - memory[2];
    Real step = 0.0;
    if (std::abs(change_of_slip) > kFlat && change_of_xi != 0.0) {
      step = -slip * change_of_xi / change_of_slip;
      // More friction, less slip: the slope of u over ξ is negative, so ξ must follow the sign of
      // u.
      if (safeguard_ && step * slip < 0.0) step = gain_ * slip;
    } else if (safeguard_ || first) {
      step = gain_ * slip;
    }
    if (safeguard_) step = std::clamp(step, -kLargestStep, kLargestStep);
    memory[1] = xi;
    memory[2] = slip;
    memory[0] = xi + step;
  }

  Real gain_;
  bool keep_through_slip_;
  bool safeguard_;
};

}  // namespace stiction
