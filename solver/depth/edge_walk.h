// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/lanes/lane_geometry.h"
#include "solver/lanes/packed_vec3.h"
#include "solver/mesh/mesh_links.h"
#include "solver/scene/scene.h"

namespace stiction {

/// The planes of a tetrahedron's four faces side by side: of the face opposite corner k in lane k.
/// Aligned as where registers are so wide, whoever keeps it.
struct alignas(4 * sizeof(Real)) FacePlanes {
  using Four = Lanes<4 * sizeof(Real)>;
  LaneVector<Four> on;      ///< a corner of the face, m
  LaneVector<Four> normal;  ///< outward, m²
  Four length;              ///< of the normal, m²

  /// Above the planes, times the lengths of their normals, m³.
  STICTION_LANES_INLINE Four height(const Vec3& x) const {
    return dot(normal, LaneVector<Four>{Four(x.x()), Four(x.y()), Four(x.z())} - on);
  }
};

/// … and of a surface triangle.
struct TrianglePlane {
  Vec3 normal;     ///< outward, m²
  Vec3 unit;       ///< the normal over its length
  Real length[4];  ///< of its edges, m, and of the normal, m²
};

/// Scratch memory of walks.
struct WalkScratch {
  struct Hit {
    Real t;       ///< on the segment, dimensionless
    Vec3 normal;  ///< of the triangle, unit
    Real angle;   ///< of the triangle around the point, rad
  };
  std::vector<std::uint64_t> visited;  ///< per element: the last walk that came by
  std::uint64_t walk = 0;
  std::vector<FacePlanes> planes;          ///< per element, at …
  std::vector<std::uint64_t> planes_at;    ///< … these positions
  std::vector<TrianglePlane> triangle;     ///< per surface triangle, at …
  std::vector<std::uint64_t> triangle_at;  ///< … these
  std::uint64_t positions = 0;             ///< number of times that they have changed
  std::vector<std::int32_t> stack;
  std::vector<Hit> hit;

  /// Before the first walk at new positions, or in another scene, with so many elements and surface
  /// triangles.
  void begin(std::size_t elements, std::size_t triangles);
};

/// A vertex in an element of a body, whose edges may leave that.
struct Border {
  const Scene& scene;
  const MeshLinks& links;
  const std::vector<Vec3>& x;  ///< per vertex, m
  std::int32_t vertex, element;
  Real thin;  ///< ε: what is no farther apart touches, m

  const Vec3& at() const { return x[static_cast<std::size_t>(vertex)]; }
  /// The other ends of its edges.
  std::span<const std::int32_t> neighbours() const {
    const std::int32_t* const begin = &links.neighbour_begin[static_cast<std::size_t>(vertex)];
    return {links.neighbour.data() + begin[0], links.neighbour.data() + begin[1]};
  }
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

/// The lengths of edges and normal are found side by side.
STICTION_LANES_INLINE TrianglePlane triangle_plane(const std::array<Vec3, 3>& corner) {
  using Four = FacePlanes::Four;
  const PackedVec3 a(corner[0]), b(corner[1]), c(corner[2]);
  const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  const FourNumbers record[] = {(b - a).value, (c - b).value, (a - c).value,
                                PackedVec3(normal).value};
  const Real* records[4];
  for (int k = 0; k < 4; ++k) records[k] = reinterpret_cast<const Real*>(&record[k]);
  Four columns[4];
  load_records(records, columns);
  const LaneVector<Four> all{columns[0], columns[1], columns[2]};
  const Four length = sqrt(dot_as_eigen(all, all));
  const Real divisor = length[3] > 0 ? length[3] : Real(1);
  TrianglePlane plane;
  plane.normal = normal;
  plane.unit = vector_cast<Vec3>(PackedVec3(PackedVec3(normal).value / divisor));
  for (int k = 0; k < 4; ++k) plane.length[k] = length[k];
  return plane;
}

STICTION_LANES_INLINE std::array<Vec3, 3> corners_of(std::size_t t, const Scene& scene,
                                                     const std::vector<Vec3>& x) {
  const auto& v = scene.topology.triangle[t].vertex;
  return {x[static_cast<std::size_t>(v[0])], x[static_cast<std::size_t>(v[1])],
          x[static_cast<std::size_t>(v[2])]};
}

/// The plane of surface triangle t with these corners, found once for all at the present positions.
STICTION_LANES_INLINE const TrianglePlane& plane_at(std::size_t t,
                                                    const std::array<Vec3, 3>& corner,
                                                    WalkScratch& scratch) {
  if (scratch.triangle_at[t] != scratch.positions) {
    scratch.triangle_at[t] = scratch.positions;
    scratch.triangle[t] = triangle_plane(corner);
  }
  return scratch.triangle[t];
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
