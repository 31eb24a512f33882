// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>

#include "solver/friction/rules/bias_vector.h"

namespace stiction {

/// The bias vector with a gain of its own for each contact, by Aitken's Δ² for vectors
/// [IronsTuck1969]:
///
///   ωᵏ = −ωᵏ⁻¹ rᵏ⁻¹·(rᵏ − rᵏ⁻¹)/|rᵏ − rᵏ⁻¹|²,   c ← c + ωᵏ rᵏ,   r = u, ω⁰ = g
///
/// which is the secant iteration for a vector and Anderson's acceleration with one step of history.
/// ω stays within [0.1, 1.5]: a contact's neighbours learn too, and what they change reads as
/// slope. Where |Δr| is round-off (≤ 1e-14 m/s) ω is held.
struct AitkenVector {
  static constexpr RuleCard kCard{
      "c, the slip before and the contact's gain",
      "inside the cone; no gain beyond 1.5; no convergence proven where contacts couple"};
  static constexpr bool kWarmStart = false;
  static constexpr int kValues = 7;
  static constexpr std::array kParameters{parameter::kGain, parameter::kMemory};

  explicit AitkenVector(const RuleSettings& given)
      : bias_(given),
        gain_(value_of(parameter::kGain, given)),
        keep_through_slip_(is_on(parameter::kMemory, given)) {}

  void reset(Real* memory) const {
    std::fill_n(memory, kValues, 0.0);
    memory[6] = gain_;
  }

  SlipSolution solve(const SlipProblem& problem, Real* memory) const {
    Eigen::Map<Vec3> bias(memory), before(memory + 3);
    if (problem.first_sweep) {
      bias -= problem.normal.dot(bias) * problem.normal;
      if (problem.was == ContactStatus::kStick) {
        Real& gain = memory[6];
        const Vec3 change = problem.start_slip - before;
        const Real size2 = change.squaredNorm();
        // Before the first slip there is nothing to take a slope from.
        if (size2 > kRoundOff * kRoundOff && !before.isZero(0.0)) {
          gain = std::clamp(-gain * before.dot(change) / size2, kLeast, kMost);
        }
        bias += gain * problem.start_slip;
        before = problem.start_slip;
      }
    }
    const SlipSolution solution = bias_.project(problem, bias);
    if (solution.status == ContactStatus::kSlip && !keep_through_slip_) reset(memory);
    return solution;
  }

 private:
  static constexpr Real kRoundOff = by_precision(1e-14, 1e-8);  // m/s
  static constexpr Real kLeast = 0.1, kMost = 1.5;

  BiasVector bias_;
  Real gain_;
  bool keep_through_slip_;
};

}  // namespace stiction
