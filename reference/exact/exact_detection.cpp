// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/exact_detection.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "reference/exact/kernels.h"

namespace stiction::reference {

namespace {

using RationalTriangle = RationalKernel::Triangle_3;
// A tree over doubles says about how far the surface is; rationals decide among what is near.
using Iterator = std::vector<FilteredKernel::Triangle_3>::const_iterator;
using FilteredPrimitive = CGAL::AABB_triangle_primitive<FilteredKernel, Iterator>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<FilteredKernel, FilteredPrimitive>>;
using Corners = Eigen::Matrix<double, 3, 4>;
using Eigen::Index;
using Eigen::Vector3d;

void demand(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("exact detection: ") + what);
}

/// The double nearest to q. CGAL::to_double truncates or worse; start there and walk.
double nearest(const Exact& q) {
  double value = CGAL::to_double(q);
  const auto error = [&](double candidate) { return CGAL::abs(Exact(candidate) - q); };
  for (const double direction : {-1.0, 1.0}) {
    const double bound = direction * std::numeric_limits<double>::infinity();
    for (double next = std::nextafter(value, bound); error(next) < error(value);
         next = std::nextafter(value, bound)) {
      value = next;
    }
  }
  return value;
}

Vector3d nearest(const RationalKernel::Point_3& p) {
  return {nearest(p.x()), nearest(p.y()), nearest(p.z())};
}

/// Signs of the volumes that the point makes with the four faces, relative to the tetrahedron's
/// own.
Side side_of(const Vector3d& point, const Corners& x) {
  std::array<FilteredKernel::Point_3, 4> corner;
  for (std::size_t k = 0; k < 4; ++k) corner[k] = filtered(x.col(static_cast<Index>(k)));
  const CGAL::Orientation own = CGAL::orientation(corner[0], corner[1], corner[2], corner[3]);
  demand(own != CGAL::COPLANAR, "a tetrahedron is flat");
  bool on_face = false;
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<FilteredKernel::Point_3, 4> moved = corner;
    moved[k] = filtered(point);
    const CGAL::Orientation sign = CGAL::orientation(moved[0], moved[1], moved[2], moved[3]);
    if (sign == CGAL::COPLANAR) {
      on_face = true;
    } else if (sign != own) {
      return Side::outside;
    }
  }
  return on_face ? Side::boundary : Side::inside;
}

Corners corners_of(const TetMesh& mesh, Index tetrahedron) {
  Corners x;
  for (Index k = 0; k < 4; ++k) x.col(k) = mesh.vertices.col(mesh.tetrahedra(k, tetrahedron));
  return x;
}

/// Closest point of a triangle (Ericson's regions), exactly: weights, which say the point too.
std::array<Exact, 3> closest_weights(const RationalKernel::Point_3& p, const RationalTriangle& t) {
  const auto ab = t[1] - t[0];
  const auto ac = t[2] - t[0];
  const auto ap = p - t[0];
  const Exact d1 = ab * ap;
  const Exact d2 = ac * ap;
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const auto bp = p - t[1];
  const Exact d3 = ab * bp;
  const Exact d4 = ac * bp;
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const Exact vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const Exact v = d1 / (d1 - d3);
    return {1 - v, v, 0};
  }
  const auto cp = p - t[2];
  const Exact d5 = ab * cp;
  const Exact d6 = ac * cp;
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const Exact vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const Exact w = d2 / (d2 - d6);
    return {1 - w, 0, w};
  }
  const Exact va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const Exact w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const Exact sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

RationalKernel::Point_3 combine(const RationalTriangle& t, const std::array<Exact, 3>& w) {
  return {w[0] * t[0].x() + w[1] * t[1].x() + w[2] * t[2].x(),
          w[0] * t[0].y() + w[1] * t[1].y() + w[2] * t[2].y(),
          w[0] * t[0].z() + w[1] * t[1].z() + w[2] * t[2].z()};
}

}  // namespace

struct ExactBody::Tree {
  std::vector<RationalTriangle> triangles;
  std::vector<FilteredKernel::Triangle_3> rounded;  ///< the same, to reckon with in doubles
  std::vector<Eigen::AlignedBox3d> boxes;           ///< of the triangles
  AabbTree tree;
};

Side side_of_tetrahedron(const Vector3d& point, const Corners& corners) {
  demand(point.allFinite() && corners.allFinite(), "a coordinate is not finite");
  return side_of(point, corners);
}

Eigen::Vector4d exact_weights(const Vector3d& point, const Corners& corners) {
  demand(point.allFinite() && corners.allFinite(), "a coordinate is not finite");
  std::array<RationalKernel::Point_3, 4> x;
  for (std::size_t k = 0; k < 4; ++k) x[k] = rational(corners.col(static_cast<Index>(k)));
  const Exact whole = CGAL::volume(x[0], x[1], x[2], x[3]);
  demand(whole != 0, "a tetrahedron is flat");
  Eigen::Vector4d weights;
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<RationalKernel::Point_3, 4> moved = x;
    moved[k] = rational(point);
    weights[static_cast<Index>(k)] =
        nearest(Exact(CGAL::volume(moved[0], moved[1], moved[2], moved[3]) / whole));
  }
  return weights;
}

ExactBody::ExactBody(const TetMesh& mesh) : mesh_(mesh), tree_(std::make_unique<Tree>()) {
  demand(mesh.vertices.allFinite(), "a coordinate is not finite");
  demand(mesh.tetrahedra.cols() > 0, "the body has no tetrahedra");
  demand(mesh.tetrahedra.minCoeff() >= 0 && mesh.tetrahedra.maxCoeff() < mesh.vertices.cols(),
         "a tetrahedron names no such vertex");
  for (Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    const Corners x = corners_of(mesh, e);
    demand(CGAL::orientation(filtered(x.col(0)), filtered(x.col(1)), filtered(x.col(2)),
                             filtered(x.col(3))) == CGAL::POSITIVE,
           "a tetrahedron is flat or inverted");
  }
  surface_ = surface_triangles(mesh.tetrahedra);
  for (Index f = 0; f < surface_.cols(); ++f) {
    std::array<Vector3d, 3> x;
    Eigen::AlignedBox3d box;
    for (Index k = 0; k < 3; ++k) {
      x[static_cast<std::size_t>(k)] = mesh.vertices.col(surface_(k, f));
      box.extend(x[static_cast<std::size_t>(k)]);
    }
    tree_->triangles.emplace_back(rational(x[0]), rational(x[1]), rational(x[2]));
    tree_->rounded.emplace_back(filtered(x[0]), filtered(x[1]), filtered(x[2]));
    tree_->boxes.push_back(box);
  }
  tree_->tree.rebuild(tree_->rounded.cbegin(), tree_->rounded.cend());
  tree_->tree.accelerate_distance_queries();
}

ExactBody::~ExactBody() = default;
ExactBody::ExactBody(ExactBody&&) noexcept = default;
ExactBody& ExactBody::operator=(ExactBody&&) noexcept = default;

const Eigen::Matrix3Xi& ExactBody::surface() const { return surface_; }

std::vector<Index> ExactBody::tetrahedra_at(const Vector3d& point) const {
  demand(point.allFinite(), "a coordinate is not finite");
  std::vector<Index> found;
  for (Index e = 0; e < mesh_.tetrahedra.cols(); ++e) {
    const Corners x = corners_of(mesh_, e);
    // Comparisons of doubles are exact, so that the box may decide what lies outside.
    if ((point.array() < x.rowwise().minCoeff().array()).any()) continue;
    if ((point.array() > x.rowwise().maxCoeff().array()).any()) continue;
    if (side_of(point, x) != Side::outside) found.push_back(e);
  }
  return found;
}

Side ExactBody::side(const Vector3d& point) const {
  const std::vector<Index> holders = tetrahedra_at(point);
  if (holders.empty()) return Side::outside;
  for (const Index e : holders) {
    if (side_of(point, corners_of(mesh_, e)) == Side::inside) return Side::inside;
  }
  // On a face of each of its holders: on the body's, too, only if on an outer triangle.
  for (Index f = 0; f < surface_.cols(); ++f) {
    if (!tree_->boxes[static_cast<std::size_t>(f)].contains(point)) continue;
    const FilteredKernel::Triangle_3 triangle(filtered(mesh_.vertices.col(surface_(0, f))),
                                              filtered(mesh_.vertices.col(surface_(1, f))),
                                              filtered(mesh_.vertices.col(surface_(2, f))));
    if (triangle.has_on(filtered(point))) return Side::boundary;
  }
  return Side::inside;
}

ClosestPoint ExactBody::closest_point(const Vector3d& point) const {
  demand(point.allFinite(), "a coordinate is not finite");
  const RationalKernel::Point_3 p = rational(point);
  // Far above the rounding of a distance that doubles say. Boxes within it leave a few triangles to
  // compare exactly.
  const double about =
      std::sqrt(tree_->tree.squared_distance(filtered(point))) * (1.0 + 1e-6) +
      1e-9 * std::max(point.cwiseAbs().maxCoeff(), mesh_.vertices.cwiseAbs().maxCoeff());
  struct Near {
    Index triangle;
    std::array<Exact, 3> weights;
    RationalKernel::Point_3 foot;
    Exact squared_distance;
  };
  std::vector<Near> near;
  for (Index f = 0; f < surface_.cols(); ++f) {
    const auto k = static_cast<std::size_t>(f);
    if (tree_->boxes[k].squaredExteriorDistance(point) > about * about) continue;
    const std::array<Exact, 3> weights = closest_weights(p, tree_->triangles[k]);
    const RationalKernel::Point_3 foot = combine(tree_->triangles[k], weights);
    near.push_back({f, weights, foot, CGAL::squared_distance(p, foot)});
  }
  const auto by_distance = [](const Near& a, const Near& b) {
    return a.squared_distance < b.squared_distance;
  };
  const Near& nearest_one = *std::min_element(near.begin(), near.end(), by_distance);
  ClosestPoint result;
  result.squared_distance = nearest(nearest_one.squared_distance);
  result.triangle = nearest_one.triangle;  // the first of equals
  result.point = nearest(nearest_one.foot);
  for (std::size_t c = 0; c < 3; ++c) {
    result.weights[static_cast<Index>(c)] = nearest(nearest_one.weights[c]);
  }
  for (const Near& each : near) {
    if (each.squared_distance != nearest_one.squared_distance) continue;
    result.unique_point = result.unique_point && each.foot == nearest_one.foot;
    result.triangles.push_back(each.triangle);
  }
  return result;
}

}  // namespace stiction::reference
