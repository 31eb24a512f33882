// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/staying.h"

#include <algorithm>
#include <cmath>

#include "solver/detection/lasting.h"
#include "solver/detection/pair_candidates.h"

namespace stiction {

namespace {

// Where edges and heights of triangles change by less than this share each, directions turn by less
// than kTurns, rad: an edge by asin(2σ), a triangle's normal by asin(2σ/(1 − 2σ)).
constexpr Real kShare = 0.02, kTurns = 0.09;

// How far a vertex and a triangle may move, m, while it can rest on it or can't, as it is now
// (can_rest_on in nearest_face.h); 0 where that is not sure.
Real rests_within(const Topology& topology, const std::vector<Vec3>& x, std::int32_t vertex,
                  std::int32_t t, bool can_rest) {
  const Topology::Triangle& triangle = topology.triangle[static_cast<std::size_t>(t)];
  const Vec3 normal = outward_normal(triangle, x);
  const auto v = static_cast<std::size_t>(vertex);
  const auto corner = [&](int k) -> const Vec3& {
    return x[static_cast<std::size_t>(triangle.vertex[k])];
  };
  Real least = least_height(corner(0), corner(1), corner(2));
  Real behind = -1.0;  // sine of the largest angle by which an edge leads behind the plane
  for (std::int32_t k = topology.neighbour_begin[v]; k < topology.neighbour_begin[v + 1]; ++k) {
    const Vec3 edge =
        x[static_cast<std::size_t>(topology.neighbour[static_cast<std::size_t>(k)])] - x[v];
    const Real length = edge.norm();
    least = std::min(least, length);
    behind = std::max(behind, -normal.dot(edge) / length);
  }
  const bool sure = can_rest ? behind < kBehind - kTurns : behind > kBehind + kTurns;
  return sure ? kShare * least : Real(0);
}

}  // namespace

Real stays_within(const Topology& topology, const PairOptions& options, const PairSearch& search,
                  const PairSearch::Group& group, const PairContact& contact) {
  const std::vector<Vec3>& x = search.predicted;
  const Vec3& point = x[static_cast<std::size_t>(contact.vertex)];
  const auto body = static_cast<std::size_t>(second_of(group.key));
  const Real rounding = list_rounding(search, point.norm());
  const Real moved = (point - search.reference[static_cast<std::size_t>(contact.vertex)]).norm() +
                     search.moved[body] + rounding;
  const auto distance = [&](std::int32_t t) {
    return std::sqrt(project_on(topology, x, point, t).nearest.distance2);
  };
  const auto rests = [&](std::int32_t t, bool can_rest) {
    return rests_within(topology, x, contact.vertex, t, can_rest);
  };
  const auto begin = search.near.begin() + group.near_begin;
  const auto end = search.near.begin() + group.near_end;
  if (std::none_of(begin, end,
                   [&](const auto& near) { return near.triangle == contact.triangle; })) {
    return 0.0;
  }
  const Real own = distance(contact.triangle);
  const auto farther_within = [&](Real other) {
    return ((1 + options.tie_margin) * other - own) / (2 + options.tie_margin) - rounding;
  };
  // Of those that the list does not name.
  Real least = farther_within(group.near_reach - moved);
  bool passes_over = false;
  for (auto near = begin; near != end; ++near) {
    if (near->triangle == contact.triangle) continue;
    if (farther_within(near->distance - moved) >= least) break;
    Real within = farther_within(distance(near->triangle));
    if (options.face == PairFace::kOpposed) {
      const Real over = rests(near->triangle, false);
      passes_over = passes_over || over > within;
      within = std::max(within, over);
    }
    least = std::min(least, within);
    if (!(least > 0.0)) return 0.0;
  }
  return passes_over ? std::min(least, rests(contact.triangle, true)) : least;
}

void note_staying(const Topology& topology, const PairOptions& options, const PairSearch& search,
                  const PairContact& contact, PairSearch::Group& group) {
  const bool same = contact.triangle == group.stays_on && group.near_element == contact.element;
  group.stays_on = contact.triangle;
  note_lasting(same, paths(topology, search, group.key), group.stayed, group.stays_until,
               [&] { return stays_within(topology, options, search, group, contact); });
}

}  // namespace stiction
