// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/edge_exit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/lanes/in_registers.h"
#include "solver/lanes/lane_geometry.h"
#include "solver/lanes/lane_width.h"
#include "solver/lanes/packed_vec3.h"

namespace stiction {

namespace {

constexpr Real kPi = 3.14159265358979323846;

// Crossings this many times `thin` apart are one: where two planes cross a segment near their
// common edge, rounding is divided by the sine of the segment's slope to them.
constexpr Real kSame = 16.0;

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

// Above the planes, times the lengths of their normals.
STICTION_LANES_INLINE FacePlanes::Four height(const FacePlanes& face, const Vec3& x) {
  using Four = FacePlanes::Four;
  return dot(face.normal, LaneVector<Four>{Four(x.x()), Four(x.y()), Four(x.z())} - face.on);
}

// Angle of the triangle around a point of it, as its distances from the edges a→b, b→c, c→a say:
// touched or not.
Real angle_around(const std::array<Vec3, 3>& corner, const std::array<bool, 3>& touched) {
  const int count = touched[0] + touched[1] + touched[2];
  if (count == 0) return 2 * kPi;
  if (count != 2) return kPi;
  const std::size_t at = !touched[0] ? 2 : !touched[1] ? 0 : 1;
  const Vec3 one = corner[(at + 1) % 3] - corner[at], other = corner[(at + 2) % 3] - corner[at];
  return std::atan2(one.cross(other).norm(), one.dot(other));
}

// The lengths of edges and normal are found side by side.
STICTION_LANES_INLINE TrianglePlane plane_of(const std::array<Vec3, 3>& corner) {
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

// `length`: of the segment p → q, m.
STICTION_LANES_INLINE void hit_triangle(const std::array<Vec3, 3>& corner,
                                        const TrianglePlane& plane, const Vec3& p, const Vec3& q,
                                        Real length, Real thin,
                                        std::vector<WalkScratch::Hit>& hits) {
  const Real p_height = plane.normal.dot(p - corner[0]), q_height = plane.normal.dot(q - corner[0]);
  if (const Real slack = thin * plane.length[3]; !(p_height <= slack && q_height > slack)) return;
  const Vec3 along = q - p;
  std::array<bool, 3> touched = {};
  for (std::size_t k = 0; k < 3; ++k) {
    const Real side = along.dot((corner[k] - p).cross(corner[(k + 1) % 3] - p));
    const Real slack = thin * length * plane.length[k];
    if (!(side >= -slack)) return;
    touched[k] = side <= slack;
  }
  hits.push_back({std::max(Real(0), -p_height / (q_height - p_height)), plane.unit,
                  angle_around(corner, touched)});
}

// One crossing of those that are as near as the nearest.
Exit merge(const std::vector<WalkScratch::Hit>& hits, Real first, Real same) {
  Exit exit{first, Vec3::Zero()};
  const WalkScratch::Hit* nearest = nullptr;
  int count = 0;
  for (const WalkScratch::Hit& hit : hits) {
    if (hit.t > first + same) continue;
    exit.normal += hit.angle * hit.normal;
    if (nearest == nullptr || hit.t < nearest->t) nearest = &hit;
    ++count;
  }
  const Real length = exit.normal.norm();
  exit.normal = count == 1 || !(length > 0.0) ? nearest->normal : Vec3(exit.normal / length);
  return exit;
}

}  // namespace

void WalkScratch::begin(std::size_t elements, std::size_t triangles) {
  ++positions;
  triangle.resize(triangles);
  triangle_at.resize(triangles, 0);
  visited.resize(elements, 0);
  planes.resize(elements);
  planes_at.resize(elements, 0);
}

namespace {

STICTION_LANES_INLINE Real largest(const FacePlanes::Four& of) {
  return std::max(std::max(of[0], of[1]), std::max(of[2], of[3]));
}
STICTION_LANES_INLINE Real smallest(const FacePlanes::Four& of) {
  return std::min(std::min(of[0], of[1]), std::min(of[2], of[3]));
}

// A segment, and what a walk along it needs.
struct Walk {
  const Scene& scene;
  const MeshLinks& links;
  const std::vector<Vec3>& x;
  const Vec3 &p, &q;
  Real thin, length;

  const Vec3& at(std::int32_t v) const { return x[static_cast<std::size_t>(v)]; }
};

// Leaves the triangles through which the segment leaves in `scratch.hit`, up to the nearest at least;
// returns where that is, infinity for none.
STICTION_LANES_INLINE Real walk_from(std::int32_t element, const Walk& walk, WalkScratch& scratch) {
  using Four = FacePlanes::Four;
  const Real same = kSame * walk.thin / walk.length;
  Real first = std::numeric_limits<Real>::infinity();
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
    if (scratch.planes_at[e] != scratch.positions) {
      scratch.planes_at[e] = scratch.positions;
      const auto& v = walk.scene.elements[e].vertex;
      scratch.planes[e] = face_planes(walk.at(v[0]), walk.at(v[1]), walk.at(v[2]), walk.at(v[3]));
    }
    const FacePlanes& face = scratch.planes[e];
    const Four p_height = height(face, walk.p), q_height = height(face, walk.q),
               slack = Four(walk.thin) * face.length;
    const auto p_above = slack < p_height, q_above = slack < q_height;
    if (!none(p_above & q_above)) continue;
    // The part [from, to] of the segment that is within `thin` of the tetrahedron.
    const Four rise = q_height - p_height;
    const Four crossing = (slack - p_height) / choose(p_above | q_above, rise, one);
    const Real from = largest(choose(p_above, crossing, zero));
    const Real to = smallest(choose(q_above, crossing, one));
    if (from > to || from > first + same) continue;
    // Faces that this part comes near are those that it may go on through.
    const Four begins = p_height + Four(from) * rise, ends = p_height + Four(to) * rise;
    const unsigned not_near = (greater(begins, ends) < -slack).bits();
    for (int k = 0; k < 4; ++k) {
      if ((not_near >> k & 1U) != 0) continue;
      const std::int32_t behind = walk.links.behind[e][static_cast<std::size_t>(k)];
      if (behind >= 0) {
        visit(behind);
        continue;
      }
      const auto t = static_cast<std::size_t>(-1 - behind);
      const auto& c = walk.scene.topology.triangle[t].vertex;
      const std::array<Vec3, 3> corner = {walk.at(c[0]), walk.at(c[1]), walk.at(c[2])};
      if (scratch.triangle_at[t] != scratch.positions) {
        scratch.triangle_at[t] = scratch.positions;
        scratch.triangle[t] = plane_of(corner);
      }
      hit_triangle(corner, scratch.triangle[t], walk.p, walk.q, walk.length, walk.thin,
                   scratch.hit);
    }
    for (const WalkScratch::Hit& hit : scratch.hit) first = std::min(first, hit.t);
  }
  return first;
}

}  // namespace

bool find_exit(const Scene& scene, const MeshLinks& links, const std::vector<Vec3>& x,
               const Vec3& p, const Vec3& q, std::int32_t element, Real thin, WalkScratch& scratch,
               Exit& exit) {
  const Real length = (q - p).norm();
  if (!(length > 0.0 && std::isfinite(length))) return false;
  scratch.hit.clear();
  scratch.stack.clear();
  ++scratch.walk;
  const Walk walk{scene, links, x, p, q, thin, length};
  Real first = 0.0;
  in_registers(
      lane_width(), [&]() __attribute__((always_inline)) {
        first = walk_from(element, walk, scratch);
      });
  if (scratch.hit.empty()) return false;
  exit = merge(scratch.hit, first, kSame * thin / length);
  return true;
}

}  // namespace stiction
