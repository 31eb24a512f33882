// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "solver/friction/rule.h"

namespace stiction {

/// Warm-started projected Gauss–Seidel: friction remembered as a vector, three values a contact.
/// The last step's force, projected on the tangent plane and clamped to the present cone, is
/// applied first to all contacts; then a forward projected Gauss–Seidel pass removes the slip that
/// is left.
///
///   f ← P(f − ω u/w),   u = ũ + w f,   P: projection on |f| ≤ μ fⁿ
///
/// Unlike a scalar ξ it acts on both components of the slip, and never divides by ũ. At rest f is
/// what it was, u = 0, and nothing changes. A contact at the cone keeps its clamped force, which is
/// Coulomb's sliding friction as soon as the slip has turned it (within a step when ũ dominates).
struct StoredVector {
  static constexpr RuleCard kCard{
      "f",
      "inside the cone; Gauss–Seidel on a convex problem once normal forces stand still, so that "
      "slip falls in every direction for 0 < ω < 2"};
  static constexpr bool kWarmStart = true;
  static constexpr int kValues = 3;
  /// ≤ 1.3 is known to be good.
  static constexpr RuleParameter kRelaxation{.name = "relaxation",
                                             .help = "ω, over-relaxation of each correction",
                                             .initial = 1.0,
                                             .low = 0.0,
                                             .high = 2.0,
                                             .open = true,
                                             .told_when_set = true};
  static constexpr std::array kParameters{kRelaxation};

  explicit StoredVector(const RuleSettings& given) : relaxation_(value_of(kRelaxation, given)) {}

  void reset(Real* memory) const { memory[0] = memory[1] = memory[2] = 0.0; }

  Vec3 start(const Real* memory) const { return {memory[0], memory[1], memory[2]}; }

  template <class Vector>
  SlipSolutionOf<Vector> solve(const SlipProblemOf<Vector>& problem, Real* memory) const {
    const Vector slip = problem.free_slip + problem.inverse_mass * problem.force;
    SlipSolutionOf<Vector> solution{problem.force - relaxation_ / problem.inverse_mass * slip,
                                    ContactStatus::kStick};
    const Real size2 = solution.force.squaredNorm();
    if (size2 > problem.bound * problem.bound) {
      solution = {problem.bound / std::sqrt(size2) * solution.force, ContactStatus::kSlip};
    }
    memory[0] = solution.force.x();
    memory[1] = solution.force.y();
    memory[2] = solution.force.z();
    return solution;
  }

 private:
  Real relaxation_;
};

}  // namespace stiction
