// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/edge_exit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stiction {

namespace {

constexpr Real kPi = 3.14159265358979323846;

// Crossings this many times `thin` apart are one: where two planes cross a segment near their
// common edge, rounding is divided by the sine of the segment's slope to them.
constexpr Real kSame = 16.0;

FacePlanes face_planes(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
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
FacePlanes::Four height(const FacePlanes& face, const Vec3& x) {
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

TrianglePlane plane_of(const std::array<Vec3, 3>& corner) {
  TrianglePlane plane;
  plane.normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  plane.length = plane.normal.norm();
  plane.unit = plane.normal.normalized();
  for (std::size_t k = 0; k < 3; ++k) plane.edge[k] = (corner[(k + 1) % 3] - corner[k]).norm();
  return plane;
}

// `length`: of the segment p → q, m.
void hit_triangle(const std::array<Vec3, 3>& corner, const TrianglePlane& plane, const Vec3& p,
                  const Vec3& q, Real length, Real thin, std::vector<WalkScratch::Hit>& hits) {
  const Real p_height = plane.normal.dot(p - corner[0]), q_height = plane.normal.dot(q - corner[0]);
  if (const Real slack = thin * plane.length; !(p_height <= slack && q_height > slack)) return;
  const Vec3 along = q - p;
  std::array<bool, 3> touched = {};
  for (std::size_t k = 0; k < 3; ++k) {
    const Real side = along.dot((corner[k] - p).cross(corner[(k + 1) % 3] - p));
    const Real slack = thin * length * plane.edge[k];
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

bool find_exit(const Scene& scene, const MeshLinks& links, const std::vector<Vec3>& x,
               const Vec3& p, const Vec3& q, std::int32_t element, Real thin, WalkScratch& scratch,
               Exit& exit) {
  const auto at = [&](std::int32_t v) -> const Vec3& { return x[static_cast<std::size_t>(v)]; };
  const Real length = (q - p).norm();
  if (!(length > 0.0 && std::isfinite(length))) return false;
  const Real same = kSame * thin / length;
  Real first = std::numeric_limits<Real>::infinity();
  scratch.hit.clear();
  scratch.stack.clear();
  ++scratch.walk;
  const auto visit = [&](std::int32_t e) {
    std::uint64_t& last = scratch.visited[static_cast<std::size_t>(e)];
    if (last == scratch.walk) return;
    last = scratch.walk;
    scratch.stack.push_back(e);
  };
  visit(element);
  while (!scratch.stack.empty()) {
    const auto e = static_cast<std::size_t>(scratch.stack.back());
    scratch.stack.pop_back();
    const auto& v = scene.elements[e].vertex;
    if (scratch.planes_at[e] != scratch.positions) {
      scratch.planes_at[e] = scratch.positions;
      scratch.planes[e] = face_planes(at(v[0]), at(v[1]), at(v[2]), at(v[3]));
    }
    const FacePlanes& face = scratch.planes[e];
    const FacePlanes::Four p_height = height(face, p), q_height = height(face, q),
                           slack = FacePlanes::Four(thin) * face.length;
    // The part [from, to] of the segment that is within `thin` of the tetrahedron.
    Real from = 0.0, to = 1.0;
    for (int k = 0; k < 4; ++k) {
      if (p_height[k] > slack[k]) {
        from = q_height[k] > slack[k]
                   ? 2
                   : std::max(from, (p_height[k] - slack[k]) / (p_height[k] - q_height[k]));
      } else if (q_height[k] > slack[k]) {
        to = std::min(to, (slack[k] - p_height[k]) / (q_height[k] - p_height[k]));
      }
    }
    if (from > to || from > first + same) continue;
    for (int k = 0; k < 4; ++k) {
      const Real rise = q_height[k] - p_height[k];
      if (std::max(p_height[k] + from * rise, p_height[k] + to * rise) < -slack[k]) continue;
      const std::int32_t behind = links.behind[e][static_cast<std::size_t>(k)];
      if (behind >= 0) {
        visit(behind);
        continue;
      }
      const auto t = static_cast<std::size_t>(-1 - behind);
      const auto& c = scene.topology.triangle[t].vertex;
      const std::array<Vec3, 3> corner = {at(c[0]), at(c[1]), at(c[2])};
      if (scratch.triangle_at[t] != scratch.positions) {
        scratch.triangle_at[t] = scratch.positions;
        scratch.triangle[t] = plane_of(corner);
      }
      hit_triangle(corner, scratch.triangle[t], p, q, length, thin, scratch.hit);
    }
    for (const WalkScratch::Hit& hit : scratch.hit) first = std::min(first, hit.t);
  }
  if (scratch.hit.empty()) return false;
  exit = merge(scratch.hit, first, same);
  return true;
}

}  // namespace stiction
