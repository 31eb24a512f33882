// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace stiction {

/// A tetrahedral mesh: plain data shared by the solver, the references and the cases.
/// Vertex 3 of a positively oriented tetrahedron lies on the side of triangle (0, 1, 2) from which
/// that triangle looks clockwise, so that det[x1 − x0, x2 − x0, x3 − x0] = 6 · volume > 0.
struct TetMesh {
  Eigen::Matrix3Xd vertices;    ///< 3 × vertex count, m
  Eigen::Matrix4Xi tetrahedra;  ///< 4 × tetrahedron count, vertex indices
};

/// Triangles that belong to exactly one tetrahedron, oriented outwards (counter-clockwise seen from
/// outside). Shape: 3 × triangle count, vertex indices; order: by tetrahedron, then by local face.
/// `owners`, when given, gets the tetrahedron of each triangle.
Eigen::Matrix3Xi surface_triangles(const Eigen::Matrix4Xi& tetrahedra,
                                   std::vector<Eigen::Index>* owners = nullptr);

/// Signed volume of one tetrahedron, m³; positive for the orientation above.
double signed_volume(const TetMesh& mesh, Eigen::Index tetrahedron);

}  // namespace stiction
