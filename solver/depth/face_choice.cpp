// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/face_choice.h"

#include <algorithm>
#include <cmath>

namespace stiction {

namespace {

// The last step's triangle while its distance is within (1 + margin) of the one found now.
Projection keep_last(const Topology& topology, const std::vector<Vec3>& x, const Vec3& point,
                     const PairSite& site, Real margin, const Projection& found) {
  if (margin == 0.0 || site.triangle < 0 || site.triangle == found.triangle || found.triangle < 0) {
    return found;
  }
  const Projection last = project_on(topology, x, point, site.triangle);
  const Real farthest2 = (1 + margin) * (1 + margin) * found.nearest.distance2;
  return last.nearest.distance2 <= farthest2 ? last : found;
}

// Path of the vertex past the triangle in this step, m.
Vec3 path_past(const Topology& topology, const std::vector<Vec3>& x, const State& state,
               std::int32_t vertex, std::int32_t triangle) {
  const auto moved = [&](std::int32_t v) -> Vec3 {
    return x[static_cast<std::size_t>(v)] - state.position[static_cast<std::size_t>(v)].x;
  };
  Vec3 of_triangle = Vec3::Zero();
  for (const std::int32_t v : topology.triangle[static_cast<std::size_t>(triangle)].vertex) {
    of_triangle += moved(v) / 3;
  }
  return moved(vertex) - of_triangle;
}

}  // namespace

bool is_over(const Topology& topology, const std::vector<Vec3>& x, const Vec3& point,
             const Projection& on) {
  if (on.nearest.inside) return true;
  const Topology::Triangle& triangle = topology.triangle[static_cast<std::size_t>(on.triangle)];
  const Vec3& corner = x[static_cast<std::size_t>(triangle.vertex[0])];
  const Real height = outward_normal(triangle, x).dot(point - corner);
  return is_straight(std::sqrt(on.nearest.distance2), -height);
}

bool goes_on(const Topology& topology, const std::vector<Vec3>& x, std::int32_t from,
             std::int32_t to) {
  constexpr Real kSameFace = 0.87;  // cosine of 30°
  const auto normal = [&](std::int32_t t) {
    return outward_normal(topology.triangle[static_cast<std::size_t>(t)], x);
  };
  return from == to || (from >= 0 && normal(from).dot(normal(to)) > kSameFace);
}

Choice choose_face(const Topology& topology, const State& state, PairSearch& search,
                   PairSearch::Group* group, const Vec3& point, const PairSite& site, Real margin,
                   std::int32_t resting) {
  // In mean edges: how deep a vertex may stand that is not known yet.
  constexpr Real kDeepest = 1e-2;
  const std::vector<Vec3>& x = search.predicted;
  const auto keep = [&](const Projection& found) {
    return keep_last(topology, x, point, site, margin, found);
  };
  const Projection nearest = project(topology, search, group, point, site);
  const Projection kept = keep(nearest);
  // On the way to the border of a triangle that it has left for the nearest a vertex would be pushed aside,
  // by up to √(2 margin), and one that sticks over an edge in a flat face be held as by a wedge.
  const bool has_left =
      kept.nearest.distance2 > nearest.nearest.distance2 && !is_over(topology, x, point, kept);
  const Projection& best = has_left ? nearest : kept;
  // That of the last step was asked then.
  if (resting < 0 || best.triangle < 0 || best.triangle == site.triangle ||
      can_rest_on(topology, x, resting,
                  outward_normal(topology.triangle[static_cast<std::size_t>(best.triangle)], x))) {
    return {best};
  }
  const Projection other = keep(project(topology, search, group, point, site, resting));
  if (other.triangle < 0) return {best};
  if (goes_on(topology, x, site.triangle, other.triangle)) return {other, true};
  const Real deepest = kDeepest * topology.mean_edge;
  const Real depth = std::sqrt(other.nearest.distance2);
  const Vec3 path = path_past(topology, x, state, resting, other.triangle);
  if (depth > deepest + path.norm()) return {best};
  if (state.step == 0) return {other, true};  // as it was put there
  const Vec3 normal =
      outward_normal(topology.triangle[static_cast<std::size_t>(other.triangle)], x);
  return {other, true, depth - std::max(Real(0), -normal.dot(path))};
}

}  // namespace stiction
