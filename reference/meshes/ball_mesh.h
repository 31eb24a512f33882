// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

#include "reference/meshes/mesh_quality.h"
#include "solver/mesh/mesh.h"

/// Tetrahedral balls whose surface vertices lie on the sphere (to one rounding of each coordinate).
///
/// Built from the icosahedron, shell by shell: shell k = 0 … n (n the frequency) has radius R k/n
/// and 10 k² + 2 vertices, so that all edges are about as long as each other, and the surface is an
/// icosphere of 20 n² facets. Between the shells, each of the 20 sectors is a tetrahedron cut into
/// n³ cells of alternating tetrahedra and octahedra, the octahedra into four along the diagonal
/// that makes the best tetrahedra: 20 n³ in all. No Delaunay step, so no slivers, and every bit is
/// the same everywhere.
namespace stiction::reference {

struct BallOptions {
  double radius = 1.0;  ///< m
  int frequency = 8;    ///< n: 4, 8, 16 give 162, 642, 2562 surface vertices
  /// Turns the ball about its centre, which is the origin. Unturned, the lowest point is a vertex
  /// at (0, 0, −R); `facet_down` puts a facet there.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();

  /// Empty if usable, else what is wrong in words.
  [[nodiscard]] std::string check() const;
};

/// Vertices: shell by shell from the centre outwards, so that the surface ones come last.
/// Throws std::invalid_argument for options that `check` refuses.
TetMesh ball_mesh(const BallOptions& options);

/// The rotation that turns the unturned ball so that one facet, the one nearest to the middle of a
/// face of the icosahedron, is horizontal and lowest.
Eigen::Matrix3d facet_down(int frequency);

/// A rotation that takes the unit vector `from` to (0, 0, −1).
Eigen::Matrix3d turned_down(const Eigen::Vector3d& from);

/// What is known of a ball's mesh; lengths in m.
struct BallReport {
  Eigen::Index surface_vertices = 0;
  Eigen::Index facets = 0;
  Eigen::Index tetrahedra = 0;

  double volume = 0.0;            ///< m³, exact and then rounded to the nearest double
  double volume_ratio = 0.0;      ///< to the sphere's, dimensionless
  double max_radius_error = 0.0;  ///< of the surface vertices against `radius`

  double min_facet_edge = 0.0;
  double mean_facet_edge = 0.0;
  double max_facet_edge = 0.0;
  double min_facet_inradius = 0.0;
  double max_facet_inradius = 0.0;
  /// R − min ‖p‖ over the facets, min ‖p‖² exact. As the ball is convex and its vertices lie on the
  /// sphere, this is the Hausdorff distance between the two surfaces: no facet's point is farther
  /// from the sphere, and the sphere's point beyond the nearest foot is just as far from the facet.
  double hausdorff_distance = 0.0;

  MeshQuality quality;
};

/// Examines a ball about the origin. Throws std::invalid_argument if the mesh isn't one.
BallReport examine_ball(const TetMesh& mesh, double radius);

}  // namespace stiction::reference
