// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

/// How deep do bodies lie in each other? From their surfaces alone, by CGAL's exact predicates
/// (which triangle is met, which side is a point on); depths are rounded [CGAL]. It knows nothing
/// of contacts, so that it can tell what a contact method did not see.
namespace stiction::reference {

/// What it takes to ask where points, edges and rays are about a surface.
class ClosedSolid;

/// A body by its closed surface. To be asked by one thread at a time, also where nothing changes.
class Skin {
 public:
  /// Triangles (3 × count) name columns of the vertices (3 × count, m), counter-clockwise seen from
  /// outside. Vertices that no triangle names are left out of everything.
  Skin(Eigen::Matrix3Xi triangles, Eigen::Matrix3Xd vertices);

  /// As many vertices as before, elsewhere.
  void move(Eigen::Matrix3Xd vertices);

  const Eigen::Matrix3Xi& triangles() const { return triangles_; }
  const Eigen::Matrix3Xd& vertices() const { return vertices_; }
  const std::vector<std::pair<int, int>>& edges() const { return edges_; }  ///< each once
  const std::vector<int>& used() const { return used_; }  ///< vertices that a triangle names
  const Eigen::Vector3d& low() const { return low_; }     ///< corners of the bounding box, m
  const Eigen::Vector3d& high() const { return high_; }
  const ClosedSolid& solid() const;  ///< made when first asked for, and kept until vertices move

  /// How thick the body is where it is thin: straight in from the middle of a triangle to where one
  /// comes out again; a tenth of the surface's area has less, m. So neither a wedge's tip nor the
  /// frame of a drum decides. Of many triangles, evenly spread ones are asked.
  double thickness() const;
  static constexpr int kThicknessSamples = 100;

 private:
  Eigen::Matrix3Xi triangles_;
  Eigen::Matrix3Xd vertices_;
  std::vector<std::pair<int, int>> edges_;
  std::vector<int> used_;
  Eigen::Vector3d low_, high_;
  mutable std::shared_ptr<const ClosedSolid> solid_;
};

/// A point of one body inside another.
struct Overlap {
  double depth = 0.0;       ///< from the other's surface, m
  Eigen::Vector3d at;       ///< m
  bool by_an_edge = false;  ///< the point lies on an edge whose ends are both outside
};

/// The deepest place found at which `inner`'s surface lies in `outer`, if it is deeper than
/// `allowed` (m, ≥ 0): of all vertices, and of the middles of the stretches of edges that are
/// inside. Where an edge enters and leaves, its deepest point may lie somewhat deeper than the
/// middle. Two surfaces that cross do so where an edge of one meets the other, so asking both ways
/// misses nothing but a body that swallows another, of which all vertices are inside. Where
/// nothing is so deep in the other's box, or a plane parts the two, it costs no more than to see that.
std::optional<Overlap> deepest(const Skin& inner, const Skin& outer, double allowed);

}  // namespace stiction::reference
