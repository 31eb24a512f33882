// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesh_quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "reference/meshes/faces.h"

namespace stiction::reference {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace

// With n_k the outward normal of face k, of twice its area: altitude h_k = |6V|/|n_k|, dihedral
// angle between faces j and k = π − ∠(n_j, n_k).
MeshQuality mesh_quality(const TetMesh& mesh) {
  if (mesh.tetrahedra.cols() == 0 || mesh.tetrahedra.minCoeff() < 0 ||
      mesh.tetrahedra.maxCoeff() >= mesh.vertices.cols()) {
    throw std::invalid_argument("A mesh needs tetrahedra, and vertices for their corners.");
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  MeshQuality quality{.min_dihedral_angle = 180.0, .min_altitude = kInfinity};
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    Eigen::Matrix<double, 3, 4> x;
    for (Eigen::Index k = 0; k < 4; ++k) x.col(k) = mesh.vertices.col(mesh.tetrahedra(k, e));
    std::array<Eigen::Vector3d, 4> normals;
    double longest_edge = 0.0;
    double largest_normal = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      const Eigen::Vector3d origin = x.col(kFaces[k][0]);
      const Eigen::Vector3d side = x.col(kFaces[k][1]) - origin;
      normals[k] = side.cross(x.col(kFaces[k][2]) - origin);
      largest_normal = std::max(largest_normal, normals[k].norm());
      for (std::size_t j = 0; j < k; ++j) {
        const auto edge = x.col(static_cast<Eigen::Index>(k)) - x.col(static_cast<Eigen::Index>(j));
        longest_edge = std::max(longest_edge, edge.norm());
        const double angle = std::numbers::pi - std::atan2(normals[j].cross(normals[k]).norm(),
                                                           normals[j].dot(normals[k]));
        quality.min_dihedral_angle = std::min(quality.min_dihedral_angle, angle / kDegree);
        quality.max_dihedral_angle = std::max(quality.max_dihedral_angle, angle / kDegree);
      }
    }
    const double altitude = 6.0 * std::abs(signed_volume(mesh, e)) / largest_normal;
    quality.min_altitude = std::min(quality.min_altitude, altitude);
    quality.max_aspect_ratio =
        std::max(quality.max_aspect_ratio, altitude > 0.0 ? longest_edge / altitude : kInfinity);
  }
  return quality;
}

}  // namespace stiction::reference
