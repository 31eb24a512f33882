// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/depth/walk_scratch.h"
#include "solver/mesh/mesh_links.h"
#include "solver/scene/scene.h"

namespace stiction {

/// A vertex in an element of a body, whose edges may leave that.
struct Border {
  const Scene& scene;
  const MeshLinks& links;
  const std::vector<Vec3>& x;  ///< per vertex, m
  std::int32_t vertex, element;
  Real thin;  ///< ε: what is no farther apart touches, m

  const Vec3& at() const { return x[static_cast<std::size_t>(vertex)]; }
  /// The other ends of its edges.
  std::span<const std::int32_t> neighbours() const { return links.neighbours_of(vertex); }
};

/// A segment p → q, and what a walk along it needs.
struct EdgeWalk {
  const Scene& scene;
  const MeshLinks& links;
  const std::vector<Vec3>& x;
  const Vec3 &p, &q;
  Real thin;    ///< what comes so near to the segment is walked through, m
  Real length;  ///< of the segment, m
};

/// Crossings this many times `thin` apart are one: where two planes cross a segment near their
/// common edge, rounding is divided by the sine of the segment's slope to them.
inline constexpr Real kSameCrossing = 16.0;

STICTION_LANES_INLINE FacePlanes face_planes(const Vec3& a, const Vec3& b, const Vec3& c,
                                             const Vec3& d) {
  using Four = FacePlanes::Four;
  const auto of_faces = [](const Vec3& x0, const Vec3& x1, const Vec3& x2, const Vec3& x3) {
    const auto lanes = [&](int k) { return Four::of(Four::Register{x0[k], x1[k], x2[k], x3[k]}); };
    return LaneVector<Four>{lanes(0), lanes(1), lanes(2)};
  };
  // The corners of the faces, in an order that turns the normals outwards.
  const LaneVector<Four> first = of_faces(b, a, a, a), second = of_faces(c, d, b, c),
                         third = of_faces(d, c, d, b);
  const LaneVector<Four> normal = cross(second - first, third - first);
  return {first, normal, sqrt(dot(normal, normal))};
}

/// The planes of an element, found once for all at the present positions.
STICTION_LANES_INLINE const FacePlanes& planes_at(std::size_t e, const Scene& scene,
                                                  const std::vector<Vec3>& x,
                                                  WalkScratch& scratch) {
  if (scratch.planes_at[e] != scratch.positions) {
    scratch.planes_at[e] = scratch.positions;
    const auto at = [&](int k) -> const Vec3& {
      return x[static_cast<std::size_t>(scene.elements[e].vertex[k])];
    };
    scratch.planes[e] = face_planes(at(0), at(1), at(2), at(3));
  }
  return scratch.planes[e];
}

STICTION_LANES_INLINE Real largest(const FacePlanes::Four& of) {
  return std::max(std::max(of[0], of[1]), std::max(of[2], of[3]));
}
STICTION_LANES_INLINE Real smallest(const FacePlanes::Four& of) {
  return std::min(std::min(of[0], of[1]), std::min(of[2], of[3]));
}

/// Walks from the tetrahedron `element`, which p is in, along the segment through all that come within
/// `thin` of it before `first`, as a share of the segment: infinity, which `meets` may lower as it goes. Calls
/// `enters(e, planes)` with each, and `meets(t)` with each triangle of the surface near which the part of the
/// segment in one of them comes.
template <class Enters, class Meets>
STICTION_LANES_INLINE void walk_along(const EdgeWalk& walk, std::int32_t element, const Real& first,
                                      WalkScratch& scratch, const Enters& enters,
                                      const Meets& meets) {
  using Four = FacePlanes::Four;
  const Real same = kSameCrossing * walk.thin / walk.length;
  scratch.stack.clear();
  ++scratch.walk;
  const auto visit = [&](std::int32_t e) {
    std::uint64_t& last = scratch.visited[static_cast<std::size_t>(e)];
    if (last == scratch.walk) return;
    last = scratch.walk;
    scratch.stack.push_back(e);
  };
  visit(element);
  const Four zero(Real(0)), one(Real(1));
  while (!scratch.stack.empty()) {
    const auto e = static_cast<std::size_t>(scratch.stack.back());
    scratch.stack.pop_back();
    const FacePlanes& face = planes_at(e, walk.scene, walk.x, scratch);
    const Four p_height = face.height(walk.p), q_height = face.height(walk.q),
               slack = Four(walk.thin) * face.length;
    const auto p_above = slack < p_height, q_above = slack < q_height;
    if (!none(p_above & q_above)) continue;
    // The part [from, to] of the segment that is within `thin` of the tetrahedron.
    const Four rise = q_height - p_height;
    const Four crossing = (slack - p_height) / choose(p_above | q_above, rise, one);
    const Real from = largest(choose(p_above, crossing, zero));
    const Real to = smallest(choose(q_above, crossing, one));
    if (from > to || from > first + same) continue;
    enters(e, face);
    // Faces that this part comes near are those that it may go on through.
    const Four begins = p_height + Four(from) * rise, ends = p_height + Four(to) * rise;
    const unsigned not_near = (greater(begins, ends) < -slack).bits();
    for (int k = 0; k < 4; ++k) {
      if ((not_near >> k & 1U) != 0) continue;
      const std::int32_t behind = walk.links.behind[e][static_cast<std::size_t>(k)];
      if (behind >= 0) {
        visit(behind);
      } else {
        meets(static_cast<std::size_t>(-1 - behind));
      }
    }
  }
}

}  // namespace stiction
