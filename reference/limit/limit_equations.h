// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>

#include "reference/limit/limit_analysis.h"

/// Internal to limit analysis: a problem, checked, scaled and written as equations, for the program
/// in doubles and the proofs in rationals alike. Row 6b + k: force on body b; 6b + 3 + k: moment
/// about its centre of mass; then one row a clamp: the sum of its normal forces.
namespace stiction::reference {

/// A load without a bound.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Throws std::invalid_argument if the problem, the question or the options are malformed.
void check(const LimitProblem& problem, double friction, double load, const LimitOptions& options);

/// What forces and lengths are divided by: powers of two, so that scaling is exact. "Scaled units"
/// below and in the other internal headers: forces over `force`, lengths over `length`, moments
/// over their product, all dimensionless.
struct LimitScale {
  double force;   ///< next above the total weight, N
  double length;  ///< next above the scene's extent, m
};

LimitScale scale_of(const LimitProblem& problem);

/// Number of equations, that is, of rows.
int row_count(const LimitProblem& problem);

/// How often contact c is a member of clamp j.
int membership(const LimitProblem& problem, std::size_t j, std::size_t c);

/// 4 × contact count, scaled units, forces on body_a: normal force f_n, then a vector whose part
/// across n is f_t.
using ContactForces = Eigen::Matrix4Xd;

/// The column of a contact force on body_a, in scaled units: `add(row, entry)` for each entry.
/// `length`: of the scale, m. `Number` is double or an exact type.
template <class Number, class Add>
void for_wrench(const LimitProblem& problem, double length, const ContactPoint& contact,
                const std::array<Number, 3>& force, Add add) {
  for (const int side : {0, 1}) {
    const int body = side == 0 ? contact.body_a : contact.body_b;
    if (body == kFixed) continue;
    const Eigen::Vector3d& center = problem.bodies[static_cast<std::size_t>(body)].center_of_mass;
    std::array<Number, 3> arm;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      arm[k] = (Number(contact.point[axis]) - Number(center[axis])) / Number(length);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3;
      const std::size_t j = (k + 2) % 3;
      const Number moment = arm[i] * force[j] - arm[j] * force[i];
      const int row = 6 * body + static_cast<int>(k);
      add(row, side == 0 ? force[k] : Number(-force[k]));
      add(row + 3, side == 0 ? moment : Number(-moment));
    }
  }
}

}  // namespace stiction::reference
