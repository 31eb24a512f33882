// SPDX-License-Identifier: BSD-3-Clause
#include "solver/scene/swing_time.h"

#include <Eigen/Core>
#include <cmath>

namespace stiction {

double swing_time(const BodyDescription& body, const std::vector<double>& mass) {
  const auto& at = body.mesh.vertices;
  if (body.mesh.tetrahedra.cols() == 0) return 0.0;
  const Eigen::Map<const Eigen::VectorXd> m(mass.data(), at.cols());
  const Eigen::Vector3d centre = at * m / m.sum();
  const double size = 2.0 * std::sqrt((at.colwise() - centre).colwise().squaredNorm().maxCoeff());
  return size * std::sqrt(body.material.density / body.material.youngs_modulus);
}

}  // namespace stiction
