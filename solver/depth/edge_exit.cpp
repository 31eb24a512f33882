// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/edge_exit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/lanes/in_registers.h"
#include "solver/lanes/lane_geometry.h"
#include "solver/lanes/packed_vec3.h"

namespace stiction {

namespace {

constexpr Real kPi = 3.14159265358979323846;

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

// That of surface triangle t with these corners, found once for all at the present positions.
STICTION_LANES_INLINE const TrianglePlane& plane_at(std::size_t t,
                                                    const std::array<Vec3, 3>& corner,
                                                    WalkScratch& scratch) {
  if (scratch.triangle_at[t] != scratch.positions) {
    scratch.triangle_at[t] = scratch.positions;
    scratch.triangle[t] = triangle_plane(corner);
  }
  return scratch.triangle[t];
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

// Of a tetrahedron's four corners.
Vec3 middle_of(const Element& element, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (const std::int32_t v : element.vertex) sum += x[static_cast<std::size_t>(v)];
  return sum / 4;
}

}  // namespace

bool find_exit(const Scene& scene, const MeshLinks& links, const std::vector<Vec3>& x,
               const Vec3& p, const Vec3& q, std::int32_t element, Real thin, WalkScratch& scratch,
               Exit& exit) {
  const Real length = (q - p).norm();
  if (!(length > 0.0 && std::isfinite(length))) return false;
  scratch.hit.clear();
  // Where it leaves first, as far as it has been walked along.
  Real first = std::numeric_limits<Real>::infinity();
  in_registers(
      lane_width(), [&]() __attribute__((always_inline)) {
        walk_along(
            {scene, links, x, p, q, thin, length}, element, first, scratch,
            [](std::size_t, const FacePlanes&) {},
            [&](std::size_t t) __attribute__((always_inline)) {
              const std::array<Vec3, 3> corner = corners_of(t, scene, x);
              hit_triangle(corner, plane_at(t, corner, scratch), p, q, length, thin, scratch.hit);
              for (const WalkScratch::Hit& hit : scratch.hit) first = std::min(first, hit.t);
            });
      });
  if (scratch.hit.empty()) return false;
  exit = merge(scratch.hit, first, kSameCrossing * thin / length);
  return true;
}

std::int32_t element_at(const Border& border, WalkScratch& scratch) {
  const Vec3 &p = border.at(),
             middle = middle_of(border.scene.elements[static_cast<std::size_t>(border.element)],
                                border.x);
  const Real length = (p - middle).norm();
  if (!(length > 0.0 && std::isfinite(length))) return border.element;
  std::int32_t found = -1;
  Real last = std::numeric_limits<Real>::infinity();  // of the walk, which ends once it is found
  walk_along(
      {border.scene, border.links, border.x, middle, p, border.thin, length}, border.element, last,
      scratch,
      [&](std::size_t e, const FacePlanes& face) {
        if (found >= 0 || !none(FacePlanes::Four(border.thin) * face.length < face.height(p)))
          return;
        found = static_cast<std::int32_t>(e);
        last = -std::numeric_limits<Real>::infinity();
      },
      [](std::size_t) {});
  return found >= 0 ? found : border.element;
}

}  // namespace stiction
