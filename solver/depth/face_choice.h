// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "solver/depth/nearest_face.h"
#include "solver/lanes/lane_register.h"
#include "solver/state.h"

namespace stiction {

/// The triangle through which a vertex is pushed out.
struct Choice {
  Projection projection;
  bool passed_over = false;  ///< a nearer triangle, which the vertex can't rest on
  /// By how much the vertex stands deeper than it has come in this step, m: it came in through the
  /// nearer triangle. 0 where it was there before, or was put there; may be negative.
  Real unexplained = 0.0;
};

/// Whether a vertex beside a triangle is over it but for rounding: the way to the nearest point, on the border,
/// is the normal but for 1.4e-5 rad. Of its distance and how far it is below the plane, m; numbers or lanes.
template <class Number>
STICTION_LANES_INLINE auto is_straight(const Number& distance, const Number& below) {
  constexpr Real kStraight = 1 + by_precision(1e-10, 1e-6);
  return distance <= Number(kStraight) * below;
}

/// Whether a vertex is over the triangle that it was projected on, or beside it by no more than rounding.
bool is_over(const Topology& topology, const std::vector<Vec3>& x, const Vec3& point,
             const Projection& on);

/// With `resting`, the vertex's number, the nearest triangle counts only if it can rest on it; else
/// the nearest on which it can does, if the contact was there before or can have come through it in
/// this step. `margin`: see PairOptions::tie_margin. Positions are those of the search.
Choice choose_face(const Topology& topology, const State& state, PairSearch& search,
                   PairSearch::Group* group, const Vec3& point, const PairSite& site, Real margin,
                   std::int32_t resting);

/// Whether a contact that was with one triangle goes on with another.
bool goes_on(const Topology& topology, const std::vector<Vec3>& x, std::int32_t from,
             std::int32_t to);

}  // namespace stiction
