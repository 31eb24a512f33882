// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

#include "reference/meshes/mesh_quality.h"
#include "solver/mesh/mesh.h"

namespace stiction::reference {

/// A box centred at the origin, as a structured grid of `cells` cells, each split into five
/// tetrahedra. Neighbouring cells are mirror images of each other, so that the diagonals of the
/// faces they share coincide. Vertices run along x first, then y, then z; the outermost lie at ±
/// size/2 exactly. Every tetrahedron is positively oriented. `size`: edge lengths, m; `cells`:
/// cells along x, y, z. Throws std::invalid_argument for a size that is not finite and positive,
/// fewer than one cell, or more cells than an int can number.
TetMesh box_mesh(const Eigen::Vector3d& size, const Eigen::Vector3i& cells);

/// The cells nearest to cubes when the longest edge has so many, at least one along each edge.
/// `size`: edge lengths, m.
Eigen::Vector3i box_cells(const Eigen::Vector3d& size, int along_longest);

/// A volume in exact rational arithmetic.
struct ExactVolume {
  std::string fraction;  ///< m³, reduced: "p/q", or "p" where q = 1
  double nearest = 0.0;  ///< the double nearest to it, m³
};

/// Π_d (upper_d − lower_d) of the corners' coordinates as they are, without rounding. Two meshes,
/// or a mesh and its box, fill the same volume exactly iff their fractions are the same string.
/// Throws std::invalid_argument unless the corners are finite and lower ≤ upper, or where no double
/// is as great as the volume.
ExactVolume exact_box_volume(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper);

/// What is known of a tetrahedral mesh without trusting floating point. A mesh is fit for use iff
/// nothing is inverted, non-manifold or unused and the boundary is closed; whether it is the right
/// body is for the volume and the Euler characteristic to tell.
struct MeshCertificate {
  ExactVolume volume;  ///< sum of the signed volumes

  Eigen::Index non_positive_tetrahedra = 0;  ///< inverted or flat, by exact predicate
  Eigen::Index non_manifold_faces = 0;  ///< shared by more than two, or by two of one orientation
  Eigen::Index unused_vertices = 0;     ///< of no tetrahedron

  Eigen::Index boundary_triangles = 0;
  bool boundary_closed = false;  ///< each boundary edge used once in either direction, nothing else
  /// Vertices − edges + triangles of the boundary: 2 for each ball, 0 for each ring.
  Eigen::Index boundary_euler_characteristic = 0;

  MeshQuality quality;  ///< in floating point
};

/// Examines any tetrahedral mesh with CGAL's exact predicates and exact rationals [CGAL]. Throws
/// std::invalid_argument for a mesh without tetrahedra, coordinates that are not finite, a vertex
/// index out of range, or a volume that is greater than the greatest double.
MeshCertificate certify(const TetMesh& mesh);

}  // namespace stiction::reference
