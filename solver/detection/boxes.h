// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>

#include "solver/lanes/packed_vec3.h"
#include "solver/real.h"

namespace stiction {

/// The box around x(k), packed, for k from `begin` to before `end`; what is no number is not in it.
template <class At>
STICTION_LANES_INLINE Box3 box_around(std::size_t begin, std::size_t end, const At& x) {
  const Box3 none;
  PackedVec3 low = none.min(), high = none.max();
  for (std::size_t k = begin; k < end; ++k) {
    const PackedVec3 here = x(k);
    low = low.cwiseMin(here);
    high = high.cwiseMax(here);
  }
  return {vector_cast<Vec3>(low), vector_cast<Vec3>(high)};
}

// As Eigen's `contains` and `intersects`, borders included, but without branches, for what comes next is
// anybody's guess: in piles, lists are made in two thirds of the time.

/// Whether a point is in a box; what is no number is in none.
inline bool holds(const Box3& box, const Vec3& x) {
  const Vec3 &low = box.min(), &high = box.max();
  return (low[0] <= x[0]) & (low[1] <= x[1]) & (low[2] <= x[2]) & (x[0] <= high[0]) &
         (x[1] <= high[1]) & (x[2] <= high[2]);
}

/// Whether two boxes have certainly no point in common; where a border is no number, nothing is certain.
inline bool apart(const Box3& a, const Box3& b) {
  return (a.min()[0] > b.max()[0]) | (a.min()[1] > b.max()[1]) | (a.min()[2] > b.max()[2]) |
         (b.min()[0] > a.max()[0]) | (b.min()[1] > a.max()[1]) | (b.min()[2] > a.max()[2]);
}

/// Whether a box is certainly outside a half-space, m; `normal` out of it.
inline bool clear_of(const Box3& box, const Vec3& normal, const Vec3& point) {
  const Vec3 nearest = (normal.array() > 0).select(box.min(), box.max());
  return normal.dot(nearest - point) > 0;
}

}  // namespace stiction
