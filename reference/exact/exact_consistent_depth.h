// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solver/mesh/mesh.h"

/// Consistent penetration depth [Heidelberger2004] of the vertices of one tetrahedral body in
/// another: what is inside, what crosses what, and where, is decided in rationals [CGAL]; means and
/// directions, which need roots, are formed with 50 digits and then rounded, to within an ulp. No
/// tolerance anywhere. Each edge is compared with every triangle: a reference for small meshes, not
/// for a time step.
namespace stiction::reference {

struct ConsistentDepth {
  Eigen::Index vertex = 0;
  int level = 0;       ///< 0 not reached, 1 an edge leaves, 2 … by its neighbours
  double depth = 0.0;  ///< m, rounded
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, rounded
  /// How far depth, m, and direction, rad, may go per metre by which heights above planes are
  /// wrong, to first order: what rounding is to be multiplied by. A weight is wrong by 2/(a s)
  /// per metre, with the distance a of its crossing and the sine s of the edge's slope.
  double moved = 1.0;      ///< dimensionless
  double turned = 0.0;     ///< 1/m
  double agreement = 1.0;  ///< |Σ w n|/Σ w, dimensionless: rounding of a normal is divided by it
};

/// Of the surface vertices of `body` that lie in `penetrated` or on its surface, ascending.
///
/// An edge p → q of a tetrahedron of `body` leaves through the triangle T if p is not above T's
/// plane, q is, and the segment meets T, its border included: at x_e. Of these the first counts;
/// where it is on several triangles at once, an edge or a corner, n_e is the mean of theirs
/// weighted by their angles around x_e. (So an edge that touches a re-entrant edge of the surface
/// ends there.)
///   level 1   d = Σ w (x_e − p)·n_e / Σ w,  n ∥ Σ w n_e,  w = 1/(|x_e − p|² + softening²)
///   level l   d = Σ μ ((p_j − p)·n_j + d_j) / Σ μ,  n ∥ Σ μ n_j,  μ = 1/|p_j − p|²,
///             over the neighbours of levels below l;  d ≥ 0
/// Where |Σ w n| ≤ 1e-12 Σ w there is no direction and the vertex stays for a later level.
///
/// Throws std::invalid_argument if a tetrahedron is flat or inverted, anything is not finite, or
/// the softening, m, is not positive.
std::vector<ConsistentDepth> exact_consistent_depths(const TetMesh& body, const TetMesh& penetrated,
                                                     double softening);

}  // namespace stiction::reference
