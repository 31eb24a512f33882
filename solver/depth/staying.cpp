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

// The points that two triangles share, at least: none, a corner or an edge; of these that nearest to a point.
struct Shared {
  bool any = false;
  Vec3 nearest = Vec3::Zero();

  Shared(const Topology& topology, const std::vector<Vec3>& x, const Vec3& point, std::int32_t s,
         std::int32_t t) {
    const auto& of = topology.triangle[static_cast<std::size_t>(s)].vertex;
    const auto& other = topology.triangle[static_cast<std::size_t>(t)].vertex;
    for (const std::int32_t v : of) {
      if (std::find(other, other + 3, v) == other + 3) continue;
      const Vec3& corner = x[static_cast<std::size_t>(v)];
      const Vec3 edge = corner - nearest;
      const Real length2 = edge.squaredNorm();
      const Real along = any && length2 > 0.0 ? edge.dot(point - nearest) / length2 : Real(1);
      nearest = any ? Vec3(nearest + std::clamp(along, Real(0), Real(1)) * edge) : corner;
      any = true;
    }
  }
};

// How far a vertex and two triangles that share a corner or an edge may move, m, while `other` isn't nearer
// than `own` by more than the margin m of a tie. With e of what they share, which moves with them,
//
//   own distance ≤ |x − e|,   that of other ≥ |x − e| cos φ,   φ between x − e and its normal
//
// so that it is not while cos φ ≥ 1/(1 + m): of a vertex over an edge in a flat face that holds for motion
// by a share of the distance, not of the distance times m. 0 where that is not known.
Real ties_within(const Topology& topology, const std::vector<Vec3>& x, const Vec3& point,
                 std::int32_t own, std::int32_t other, Real margin, Real rounding) {
  const Shared shared(topology, x, point, own, other);
  if (!shared.any) return 0.0;
  const Vec3 from = point - shared.nearest;
  const Real length = from.norm();
  const auto& v = topology.triangle[static_cast<std::size_t>(other)].vertex;
  const auto corner = [&](int k) -> const Vec3& { return x[static_cast<std::size_t>(v[k])]; };
  const Real height = least_height(corner(0), corner(1), corner(2));
  if (!(length > rounding && height > rounding)) return 0.0;
  const Vec3 normal = outward_normal(topology.triangle[static_cast<std::size_t>(other)], x);
  // Of twice the rounding of a distance each, where the length is half of what it is.
  const Real least_cosine = (1 + 8 * rounding / length) / (1 + margin);
  if (!(least_cosine < 1.0)) return 0.0;
  const Real turned = std::atan2(from.cross(normal).norm(), std::abs(from.dot(normal)));
  // By a motion of d, x − e turns by asin(d/length) < 1.05 d/length, and the normal by less than
  // 2.3 d/height, while these are shares of a half and of kShare.
  const Real may_turn = std::acos(least_cosine) - turned;
  return std::min(
      {may_turn / (Real(1.05) / length + Real(2.3) / height), length / 2, kShare * height});
}

}  // namespace

Staying stays_within(const Topology& topology, const PairOptions& options, const PairSearch& search,
                     const PairSearch::Group& group, const PairSite& site) {
  const std::vector<Vec3>& x = search.predicted;
  const std::int32_t vertex = first_of(group.key);
  const Vec3& point = x[static_cast<std::size_t>(vertex)];
  const auto body = static_cast<std::size_t>(second_of(group.key));
  const Real rounding = list_rounding(search, point.norm());
  const Real moved = (point - search.reference[static_cast<std::size_t>(vertex)]).norm() +
                     search.moved[body] + rounding;
  const auto distance = [&](std::int32_t t) {
    return std::sqrt(project_on(topology, x, point, t).nearest.distance2);
  };
  const auto rests = [&](std::int32_t t, bool can_rest) {
    return rests_within(topology, x, vertex, t, can_rest);
  };
  const auto begin = search.near.begin() + group.near_begin;
  const auto end = search.near.begin() + group.near_end;
  if (std::none_of(begin, end, [&](const auto& near) { return near.triangle == site.triangle; })) {
    return {};
  }
  const Real own = distance(site.triangle);
  const auto farther_within = [&](Real other) {
    return ((1 + options.tie_margin) * other - own) / (2 + options.tie_margin) - rounding;
  };
  // Of those that the list does not name.
  Real least = farther_within(group.near_reach - moved);
  // While what has moved is less, none of those named is nearer, or one surely is.
  Real none_nearer = least, one_nearer = 0.0;
  for (auto near = begin; near != end; ++near) {
    if (near->triangle == site.triangle) continue;
    if (farther_within(near->distance - moved) >= least) break;
    const Real other = distance(near->triangle);
    Real within = farther_within(other);
    if (within < least) {
      within = std::max(within, ties_within(topology, x, point, site.triangle, near->triangle,
                                            options.tie_margin, rounding));
    }
    none_nearer = std::min(none_nearer, within);
    if (options.face == PairFace::kOpposed && within < least) {
      const Real over = rests(near->triangle, false);
      if (over > within) {
        within = over;
        const Real nearer =
            (own - (1 + options.tie_margin) * other) / (2 + options.tie_margin) - rounding;
        one_nearer = std::max(one_nearer, std::min(nearer, over));
      }
    }
    least = std::min(least, within);
    if (!(least > 0.0)) return {};
  }
  if (none_nearer < least) {
    least = std::max(none_nearer, std::min(least, rests(site.triangle, true)));
  }
  if (none_nearer >= least) return {least, 0};
  if (one_nearer >= least) return {least, 1};
  // Rather known for a shorter time than not.
  if (none_nearer > 0.5 * least) return {none_nearer, 0};
  if (one_nearer > 0.5 * least) return {one_nearer, 1};
  return {least, -1};
}

void note_change_of_staying(const Topology& topology, const PairOptions& options,
                            const PairSearch& search, const PairSite& site,
                            PairSearch::Group& group) {
  const bool same = site.triangle == group.stays_on && group.near_element == site.element;
  const double path = paths(topology, search, group.key);
  // Known, but measured by itself: it is beside its face.
  if (same && path < group.stays_until) return;
  group.stays_on = site.triangle;
  note_lasting(same, path, group.stayed, group.stays_until, [&] {
    const Staying staying = stays_within(topology, options, search, group, site);
    group.passes_over = staying.passes_over;
    return staying.within;
  });
}

}  // namespace stiction
