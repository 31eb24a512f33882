// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/real.h"

namespace stiction {

/// Barycentric weights of a point in a tetrahedron with the given corners, dimensionless; they sum
/// to 1. Precondition: its volume is not zero.
Vec4 barycentric(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The least weights of a point in some tetrahedra, at most as many as a register of this width has
/// lanes (lane_width.h), side by side: `least[k]` is that of the one whose corners are the vertices
/// corner[k][0 … 3], at positions `x`, m, with the bits of `barycentric`.
void least_weights(const Vec3& point, const std::vector<Vec3>& x, const std::int32_t* const* corner,
                   int count, int width, Real* least);

/// The same of a point each: `least[k]` is that of vertex point[k].
void least_weights(const std::int32_t* point, const std::vector<Vec3>& x,
                   const std::int32_t* const* corner, int count, int width, Real* least);

/// Round-off of weights of order one: a point on a shared face must not fall between its two
/// elements. A tetrahedron holds a point with no weight below this.
inline constexpr Real kOnBoundary = -by_precision(1e-12, 2e-6);

/// With weights above this the point is inside this tetrahedron and no other of an unfolded body:
/// far above round-off, far below any depth.
inline constexpr Real kInside = by_precision(1e-9, 1e-4);

/// How far a point, as far as δₐ, and the corners of a tetrahedron, as far as δ_b, may move, δₐ + δ_b,
/// m, while it doesn't hold it: how far the point is above the plane of one of its faces, less what
/// kOnBoundary forgives and what rounding adds; negative inside.
Real clearance(const Vec3& point, const std::array<Vec3, 4>& corner);

/// How far they may move while all weights are above kInside; 0 unless they are. With w the smallest
/// weight and r the radius of the inscribed sphere: each height is at least 2 (r − δ) by then, so that
/// no weight has changed by more than δ/(2 (r − δ)).
Real held_within(const Vec3& point, const std::array<Vec3, 4>& corner);

}  // namespace stiction
