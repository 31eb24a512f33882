// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "solver/friction/rule.h"

namespace stiction {

/// The fixed point in two dimensions: a tangential bias c (m/s) learns what slip the force −ũ/w
/// leaves, along ũ and across it.
///
///   c ← c + g u   if the contact stuck in the last step
///   f = P(−(ũ + c)/w),   P: projection on |f| ≤ μ fⁿ
///
/// Beyond the paper, whose scalar ξ has one unknown a contact where rest needs two. The vector is
/// kept in space (three values) and laid into the tangent plane of the present step. It never
/// divides by ũ. A clamped contact slips and forgets its bias, unless `memory` is
/// kept, which freezes it.
struct BiasVector {
  static constexpr RuleCard kCard{
      "c",
      "inside the cone; removes slip in every tangential direction where the loop gain is below 2"};
  static constexpr bool kWarmStart = false;
  static constexpr int kValues = 3;
  static constexpr std::array kParameters{parameter::kGain, parameter::kMemory};

  explicit BiasVector(const RuleSettings& given)
      : gain_(value_of(parameter::kGain, given)),
        keep_through_slip_(is_on(parameter::kMemory, given)) {}

  void reset(Real* memory) const { memory[0] = memory[1] = memory[2] = 0.0; }

  SlipSolution solve(const SlipProblem& problem, Real* memory) const {
    Eigen::Map<Vec3> bias(memory);
    if (problem.first_sweep) {
      bias -= problem.normal.dot(bias) * problem.normal;
      if (problem.was == ContactStatus::kStick) bias += gain_ * problem.start_slip;
    }
    return project(problem, bias);
  }

  /// Stick or clamp with the bias given; shared with the rules that find their bias otherwise.
  template <class Bias>
  SlipSolution project(const SlipProblem& problem, Bias&& bias) const {
    const Vec3 force = -(problem.free_slip + bias) / problem.inverse_mass;
    const Real size2 = force.squaredNorm();
    if (size2 <= problem.bound * problem.bound) return {force, ContactStatus::kStick};
    if (!keep_through_slip_) bias.setZero();
    return {problem.bound / std::sqrt(size2) * force, ContactStatus::kSlip};
  }

 private:
  Real gain_;
  bool keep_through_slip_;
};

}  // namespace stiction
