// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/lanes/lane_geometry.h"

namespace stiction {

/// A triangle a lane, with the bits of what is found of one at a time.
template <class Number>
struct LaneTriangle {
  LaneVector<Number> a, b, c;  ///< corners, m

  /// Outward, unit (`outward_normal` in nearest_face.h).
  STICTION_LANES_INLINE LaneVector<Number> normal() const {
    const LaneVector<Number> across = cross(b - a, c - a);
    const Number length2 = dot_as_eigen(across, across);
    return across / sqrt(length2);
  }
};

/// `nearest_on_triangle` (nearest.h), lane by lane, with its bits.
template <class Number>
struct LaneNearest {
  using Mask = typename Number::Mask;
  Number weight[3];
  LaneVector<Number> off;  ///< from the point to the nearest one
  Number distance2;
  Mask inside;

  STICTION_LANES_INLINE LaneNearest(const LaneVector<Number>& p, const LaneTriangle<Number>& of) {
    const auto& [a, b, c] = of;
    const Number zero(Real(0)), one(Real(1));
    const LaneVector<Number> ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const Number d1 = dot_as_eigen(ab, ap), d2 = dot_as_eigen(ac, ap), d3 = dot_as_eigen(ab, bp),
                 d4 = dot_as_eigen(ac, bp), d5 = dot_as_eigen(ab, cp), d6 = dot_as_eigen(ac, cp);
    const Number vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    const Number sum = va + vb + vc, v = vb / sum, w = vc / sum;
    weight[0] = one - v - w;
    weight[1] = v;
    weight[2] = w;
    inside = ((zero < d1) | (zero < d2)) & ((d3 < zero) | (d3 < d4)) & ((d6 < zero) | (d6 < d5)) &
             (zero < va) & (zero < vb) & (zero < vc);
    if (!all(inside)) {
      inside = zero <= zero;
      // From the last question to the first, so that the first that holds decides.
      const auto where = [&](const Mask& region, const Number& u0, const Number& u1,
                             const Number& u2) __attribute__((always_inline)) {
        weight[0] = choose(region, u0, weight[0]);
        weight[1] = choose(region, u1, weight[1]);
        weight[2] = choose(region, u2, weight[2]);
        inside = inside & ~region;
      };
      const Number beyond_b = d4 - d3, beyond_c = d5 - d6;
      const Number bc = beyond_b / (beyond_b + beyond_c), ca = d2 / (d2 - d6),
                   of_ab = d1 / (d1 - d3);
      where((va <= zero) & (zero <= beyond_b) & (zero <= beyond_c), zero, one - bc, bc);
      where((vb <= zero) & (zero <= d2) & (d6 <= zero), one - ca, zero, ca);
      where((vc <= zero) & (zero <= d1) & (d3 <= zero), one - of_ab, of_ab, zero);
      where((zero <= d6) & (d5 <= d6), zero, zero, one);
      where((zero <= d3) & (d4 <= d3), zero, one, zero);
      where((d1 <= zero) & (d2 <= zero), one, zero, zero);
    }
    off = weight[0] * a + weight[1] * b + weight[2] * c - p;
    distance2 = dot_as_eigen(off, off);
  }
};

}  // namespace stiction
