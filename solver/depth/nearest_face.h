// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "solver/contact/pair_contacts.h"
#include "solver/depth/nearest.h"
#include "solver/mesh/topology.h"
#include "solver/workspace.h"

namespace stiction {

/// A point's projection on a surface triangle; triangle −1: on none.
struct Projection {
  NearestOnTriangle nearest;
  std::int32_t triangle;
};

/// Unit, at the positions `x` (m) per vertex.
inline Vec3 outward_normal(const Topology::Triangle& triangle, const std::vector<Vec3>& x) {
  const Vec3& a = x[static_cast<std::size_t>(triangle.vertex[0])];
  const Vec3& b = x[static_cast<std::size_t>(triangle.vertex[1])];
  const Vec3& c = x[static_cast<std::size_t>(triangle.vertex[2])];
  return (b - a).cross(c - a).normalized();
}

/// Sine of the angle by which an edge may lead behind a face's plane, and a face beside an edge before
/// the plane between two bodies: surfaces bend, and a face that is the wrong one stands across.
inline constexpr Real kBehind = 0.5;

/// Whether the vertex can rest on a face with this outward normal: its own surface lies before the
/// face's plane, in so far as the edges of that surface that end at the vertex do.
bool can_rest_on(const Topology& topology, const std::vector<Vec3>& x, std::int32_t vertex,
                 const Vec3& normal);

/// An element is taken not to be squeezed to less than this share of its least width.
inline constexpr Real kSqueezed = 0.5;

Projection project_on(const Topology& topology, const std::vector<Vec3>& x, const Vec3& point,
                      std::int32_t t);

/// Nearest surface triangle of the penetrated body, of equals that of the lowest number: of those
/// near the contact's element, unless it lies so deep that one that shares no corner with the
/// element may be as near (see Topology::least_width). With `resting`, a vertex's number, only of
/// triangles that this vertex can rest on. `group`: the candidates of the contact's key, or null.
Projection project(const Topology& topology, PairSearch& search, PairSearch::Group* group,
                   const Vec3& point, const PairSite& site, std::int32_t resting = -1);

}  // namespace stiction
