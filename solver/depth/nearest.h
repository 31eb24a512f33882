// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "solver/real.h"

namespace stiction {

/// Height of a triangle over its longest edge, m.
inline Real least_height(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Real longest2 =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() / std::sqrt(longest2);
}

/// Nearest point of a triangle to a point, as barycentric weights of its corners (they sum to 1).
struct NearestOnTriangle {
  Vec3 weight;
  Real distance2;  ///< m²
  bool inside;     ///< the orthogonal projection falls inside the triangle
};

/// Voronoi regions of the triangle's corners, edges and face, in that order.
inline NearestOnTriangle nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b,
                                             const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const auto result = [&](Real u, Real v, Real w, bool inside) {
    const Vec3 weight(u, v, w);
    return NearestOnTriangle{weight, (u * a + v * b + w * c - p).squaredNorm(), inside};
  };
  const Real d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return result(1, 0, 0, false);
  const Vec3 bp = p - b;
  const Real d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return result(0, 1, 0, false);
  const Vec3 cp = p - c;
  const Real d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return result(0, 0, 1, false);
  const Real vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const Real t = d1 / (d1 - d3);
    return result(1 - t, t, 0, false);
  }
  const Real vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const Real t = d2 / (d2 - d6);
    return result(1 - t, 0, t, false);
  }
  const Real va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const Real t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return result(0, 1 - t, t, false);
  }
  const Real sum = va + vb + vc;
  const Real v = vb / sum, w = vc / sum;
  return result(1 - v - w, v, w, true);
}

}  // namespace stiction
