// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "solver/scene/scene.h"
#include "solver/workspace.h"

namespace stiction {

/// Predicts where the vertices come to in a step of dt (s) with these velocities, `search.predicted`,
/// and brings the candidates up to date with that: the pairs of a surface vertex and a
/// body whose tetrahedra it may be in, with those tetrahedra, and balls around the surface
/// triangles [Verlet1967's neighbour lists].
///
///   x in tetrahedron, each coordinate of each vertex within s of the reference  ⇒
///   x_reference in the tetrahedron's reference box widened by 2s
///
/// How far each body has moved since is noted (follow.h). So the lists of two bodies hold until some
/// vertex of either has moved by more than the skin s along an axis since they were made; until then a
/// step only tests what they name, and others' are made anew without them. What is found never depends
/// on when they were made. They are made from the overlap of two bodies' boxes (element_boxes.h), linear
/// in the primitives there; bodies that are apart are not looked at. Returns whether any were made anew.
bool update_candidates(const Scene& scene, Real dt, const State& state,
                       const std::vector<Velocity>& velocity, const Team* team, PairSearch& search);

/// Whether the lists of two bodies were made anew in this step: either had moved too far for them.
inline bool is_renewed(const PairSearch& search, std::int32_t a, std::int32_t b) {
  return search.renewed[static_cast<std::size_t>(a)] || search.renewed[static_cast<std::size_t>(b)];
}

/// Far above the round-off of a distance of the lists, for a vertex so far from the origin, m.
inline Real list_rounding(const PairSearch& search, Real from_origin) {
  return by_precision(1e-9, 1e-5) * search.skin + round_off(1e-14) * from_origin;
}

/// Lists the triangles near an element to which the group's vertex may be nearest while the lists
/// hold, as it is in that element:
///
///   d ≤ D + 4√3 s
///
/// with the distance d of the triangle and D of the nearest one at the reference; vertex and
/// triangles each move by at most √3 s. Lists nothing when no triangle is near the element; nor when
/// those near it are listed already, or the group's have been listed kMostListings times since lists
/// were made: a vertex on a joint of elements may change from one to another and back in each step.
void list_nearest(const Topology& topology, std::int32_t element, PairSearch::Group& group,
                  PairSearch& search);
inline constexpr int kMostListings = 8;

/// Whether it would list any.
bool is_to_list(const Topology& topology, std::int32_t element, const PairSearch::Group& group);

}  // namespace stiction
