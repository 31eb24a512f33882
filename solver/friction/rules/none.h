// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/friction/rule.h"

namespace stiction {

/// Coulomb friction without stabilisation: ξ = 1 always [Lazarevych2009, (7)–(13)].
///
///   stick   f = λ f_max = −ũ/w     λ = ũ/(ũ − u*)
///   slip    f = f_max = −μ fⁿ ũ/|ũ|
///
/// Deviation 1: the closed form −ũ/w replaces λ f_max, so that ũ → 0 is no 0/0.
/// Exact against a fixed obstacle, where contacts do not couple: the slip ends at round-off.
struct None {
  static constexpr RuleCard kCard{
      "nothing",
      "inside the cone; exact where contacts do not couple, as on a half-space; creeps elsewhere"};
  static constexpr bool kWarmStart = false;
  static constexpr int kValues = 0;
  explicit None(const RuleSettings&) {}
  void reset(Real*) const {}

  SlipSolution solve(const SlipProblem& problem, Real*) const {
    if (!can_stick(problem)) return sliding(problem);
    return {-problem.free_slip / problem.inverse_mass, ContactStatus::kStick};
  }
};

}  // namespace stiction
