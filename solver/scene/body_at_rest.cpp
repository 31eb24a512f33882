// SPDX-License-Identifier: BSD-3-Clause
#include "solver/scene/body_at_rest.h"

namespace stiction {

Lame lame(const Material& material) {
  const double nu = material.poisson_ratio;
  const double e = material.youngs_modulus;
  return {e / (2.0 * (1.0 + nu)), e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))};
}

Eigen::Matrix3d rest_edges(const TetMesh& mesh, Eigen::Index tetrahedron) {
  const auto corners = mesh.tetrahedra.col(tetrahedron);
  Eigen::Matrix3d d;
  for (int k = 0; k < 3; ++k) {
    d.col(k) = mesh.vertices.col(corners[k + 1]) - mesh.vertices.col(corners[0]);
  }
  return d;
}

std::vector<double> lumped_masses(const BodyDescription& body) {
  std::vector<double> mass(static_cast<std::size_t>(body.mesh.vertices.cols()), 0.0);
  for (Eigen::Index e = 0; e < body.mesh.tetrahedra.cols(); ++e) {
    const double quarter = 0.25 * body.material.density * signed_volume(body.mesh, e);
    for (int k = 0; k < 4; ++k) {
      mass[static_cast<std::size_t>(body.mesh.tetrahedra(k, e))] += quarter;
    }
  }
  for (double& m : mass) {
    if (m == 0.0) m = body.point_mass;
  }
  return mass;
}

}  // namespace stiction
