// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/mesh/mesh.h"

/// Do bodies fill the same space, and not only touch? Decided tetrahedron by tetrahedron with CGAL's
/// exact predicates, so that coinciding faces, vertices and whole bodies are no special cases [CGAL].
namespace stiction::reference {

struct SolidBall {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< m
  double radius = 1.0;                               ///< m
};

struct SolidPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
};

struct SolidMesh {
  TetMesh mesh;            ///< in place, m
  std::vector<bool> held;  ///< one a vertex: it cannot move; empty: none
};

using Solid = std::variant<SolidMesh, SolidBall, SolidPoint>;

struct SharedSpace {
  std::size_t first = 0, second = 0;  ///< first < second
  double depth = 0.0;                 ///< they share a ball of about this radius at least, m
};

/// Some pair of solids that share a ball of radius `allowed` (m, > 0), or none: what is that thin is
/// contact. Two points never do, nor do tetrahedra of which all vertices are held. Costs the
/// comparison of boxes where these are apart. Coordinates must be finite and below 1e30 m.
std::optional<SharedSpace> shared_space(const std::vector<Solid>& solids, double allowed);

}  // namespace stiction::reference
