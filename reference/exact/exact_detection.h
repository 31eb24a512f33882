// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "solver/mesh/mesh.h"

/// Which side of a body is a point on, and where is the surface nearest to it: without rounding, by
/// CGAL's exact predicates and an AABB tree over rationals [CGAL]. Coordinates are taken as the
/// doubles they are. The reference for the solver's detection and depths; made for thousands of
/// queries, not for a time step.
namespace stiction::reference {

enum class Side { inside, boundary, outside };

/// Of one tetrahedron (of either orientation). Throws std::invalid_argument if it is flat or
/// anything is not finite.
Side side_of_tetrahedron(const Eigen::Vector3d& point, const Eigen::Matrix<double, 3, 4>& corners);

/// Barycentric weights of a point in a tetrahedron, exact and then rounded to the nearest double:
///   x = Σ_k w_k x_k,  Σ_k w_k = 1. Throws as above.
Eigen::Vector4d exact_weights(const Eigen::Vector3d& point,
                              const Eigen::Matrix<double, 3, 4>& corners);

/// A nearest point of the surface.
struct ClosestPoint {
  double squared_distance = 0.0;  ///< m², exact and then rounded to the nearest double
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< m, rounded likewise
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  ///< on the triangle, rounded likewise
  Eigen::Index triangle = 0;                          ///< the first of `triangles`
  /// Every triangle at exactly this distance, ascending: two at an edge, a fan at a vertex, and
  /// more on the medial axis. Columns of `ExactBody::surface`.
  std::vector<Eigen::Index> triangles;
  /// False if two nearest points differ: the point lies on the medial axis, and `point` is the one
  /// on `triangle`.
  bool unique_point = true;
};

/// A tetrahedral body, prepared for queries.
class ExactBody {
 public:
  /// Throws std::invalid_argument if a tetrahedron is flat or inverted, a coordinate is not finite,
  /// or an index is out of range.
  explicit ExactBody(const TetMesh& mesh);
  ~ExactBody();
  ExactBody(ExactBody&&) noexcept;
  ExactBody& operator=(ExactBody&&) noexcept;

  /// The outer triangles in the order of `surface_triangles`.
  [[nodiscard]] const Eigen::Matrix3Xi& surface() const;

  /// Of the union of the tetrahedra. Inner faces are inside.
  [[nodiscard]] Side side(const Eigen::Vector3d& point) const;

  /// All tetrahedra that hold the point, with their own boundaries: one, or more if it lies on a
  /// shared face, edge or vertex; none outside. Ascending.
  [[nodiscard]] std::vector<Eigen::Index> tetrahedra_at(const Eigen::Vector3d& point) const;

  [[nodiscard]] ClosestPoint closest_point(const Eigen::Vector3d& point) const;

 private:
  struct Tree;
  TetMesh mesh_;
  Eigen::Matrix3Xi surface_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace stiction::reference
