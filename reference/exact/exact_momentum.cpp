// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/exact_momentum.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <stdexcept>

namespace stiction::reference {

Eigen::Vector3d exact_momentum_change(const std::vector<double>& mass,
                                      const std::vector<Eigen::Vector3d>& before,
                                      const std::vector<Eigen::Vector3d>& now) {
  using Rational = CGAL::Exact_rational;
  if (before.size() != mass.size() || now.size() != mass.size()) {
    throw std::invalid_argument("There must be a velocity before and now for each mass.");
  }
  Eigen::Vector3d change;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Rational sum(0);
    for (std::size_t k = 0; k < mass.size(); ++k) {
      if (!std::isfinite(mass[k]) || !before[k].allFinite() || !now[k].allFinite()) {
        throw std::invalid_argument("Masses and velocities must be finite.");
      }
      sum += Rational(mass[k]) * (Rational(now[k][axis]) - Rational(before[k][axis]));
    }
    change[axis] = CGAL::to_double(sum);
  }
  return change;
}

}  // namespace stiction::reference
