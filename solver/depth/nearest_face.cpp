// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/nearest_face.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/detection/pair_candidates.h"

namespace stiction {

namespace {

// The nearest of the triangles that it has been shown, of equals that of the lowest number.
struct Nearest {
  const Topology& topology;
  const std::vector<Vec3>& x;
  const Vec3& point;
  std::int32_t resting = -1;  // only triangles that this vertex can rest on; −1: any
  Projection best{{Vec3::Zero(), std::numeric_limits<Real>::infinity(), false}, -1};
  Real reach = std::numeric_limits<Real>::infinity();  // distance of the best

  void consider(std::int32_t t) {
    const Projection other = project_on(topology, x, point, t);
    const Real nearer = other.nearest.distance2 - best.nearest.distance2;
    if (nearer < 0.0 || (nearer == 0.0 && t < best.triangle)) {
      if (resting >= 0 &&
          !can_rest_on(topology, x, resting,
                       outward_normal(topology.triangle[static_cast<std::size_t>(t)], x))) {
        return;
      }
      best = other;
      reach = std::sqrt(best.nearest.distance2);
    }
  }
};

// Of the triangles of the group's list: in the order of their distances at the reference, until
// what vertex and triangles have moved since can't make the next one the nearest. None (−1) where
// the list need not name the nearest that is asked for.
Projection project_by_list(const Topology& topology, const PairSearch& search,
                           const PairSearch::Group& group, const Vec3& point, const PairSite& site,
                           std::int32_t resting) {
  const auto vertex = static_cast<std::size_t>(first_of(group.key));
  const auto body = static_cast<std::size_t>(second_of(group.key));
  const Real moved = (point - search.reference[vertex]).norm() + search.moved[body] +
                     list_rounding(search, point.norm());
  Nearest nearest{topology, search.predicted, point, resting};
  if (site.triangle >= 0) nearest.consider(site.triangle);
  for (std::int32_t k = group.near_begin; k < group.near_end; ++k) {
    const PairSearch::Near& near = search.near[static_cast<std::size_t>(k)];
    if (near.distance - moved > nearest.reach) break;
    if (near.triangle != site.triangle) nearest.consider(near.triangle);
  }
  if (resting >= 0 && nearest.reach + moved > group.near_reach) nearest.best.triangle = -1;
  return nearest.best;
}

// Of all triangles near the contact's element, or of the body's where none is near or `everywhere`
// is asked for. Begins with that of the last step, if there was one, so that most others are out of
// reach.
Projection project_by_balls(const Topology& topology, const PairSearch& search, const Vec3& point,
                            const PairSite& site, std::int32_t resting, bool everywhere) {
  constexpr Real kRounding = 1 + round_off(1e-12);
  Nearest nearest{topology, search.predicted, point, resting};
  if (site.triangle >= 0) nearest.consider(site.triangle);
  const auto consider = [&](std::int32_t t) {
    const TriangleBall& ball = search.ball[static_cast<std::size_t>(t)];
    const Real least = nearest.reach + ball.radius;
    if (t == site.triangle || (point - ball.centre).squaredNorm() > least * least * kRounding) {
      return;
    }
    nearest.consider(t);
  };
  const auto e = static_cast<std::size_t>(site.element);
  const auto begin = topology.near.begin() + topology.near_begin[e];
  const auto end = topology.near.begin() + topology.near_begin[e + 1];
  if (!everywhere) std::for_each(begin, end, consider);
  if (everywhere || begin == end) {
    const auto body = static_cast<std::size_t>(topology.element_body[e]);
    for (std::int32_t t = topology.body_triangle_begin[body];
         t < topology.body_triangle_begin[body + 1]; ++t) {
      consider(t);
    }
  }
  return nearest.best;
}

}  // namespace

bool can_rest_on(const Topology& topology, const std::vector<Vec3>& x, std::int32_t vertex,
                 const Vec3& normal) {
  const auto v = static_cast<std::size_t>(vertex);
  for (std::int32_t k = topology.neighbour_begin[v]; k < topology.neighbour_begin[v + 1]; ++k) {
    const Vec3 edge =
        x[static_cast<std::size_t>(topology.neighbour[static_cast<std::size_t>(k)])] - x[v];
    const Real along = normal.dot(edge);
    if (along < 0.0 && along * along > kBehind * kBehind * edge.squaredNorm()) return false;
  }
  return true;
}

Projection project_on(const Topology& topology, const std::vector<Vec3>& x, const Vec3& point,
                      std::int32_t t) {
  const Topology::Triangle& triangle = topology.triangle[static_cast<std::size_t>(t)];
  return {nearest_on_triangle(point, x[static_cast<std::size_t>(triangle.vertex[0])],
                              x[static_cast<std::size_t>(triangle.vertex[1])],
                              x[static_cast<std::size_t>(triangle.vertex[2])]),
          t};
}

Projection project(const Topology& topology, PairSearch& search, PairSearch::Group* group,
                   const Vec3& point, const PairSite& site, std::int32_t resting) {
  if (group != nullptr) list_nearest(topology, site.element, *group, search);
  const bool listed = group != nullptr && group->near_element == site.element;
  Projection best{{}, -1};
  if (listed) best = project_by_list(topology, search, *group, point, site, resting);
  if (best.triangle < 0) best = project_by_balls(topology, search, point, site, resting, false);
  const auto body =
      static_cast<std::size_t>(topology.element_body[static_cast<std::size_t>(site.element)]);
  const Real near = kSqueezed * topology.least_width[body];
  if (resting >= 0 || best.nearest.distance2 < near * near) return best;
  return project_by_balls(topology, search, point, site, resting, true);
}

}  // namespace stiction
