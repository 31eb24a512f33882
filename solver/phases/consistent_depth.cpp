// SPDX-License-Identifier: BSD-3-Clause
#include "solver/phases/consistent_depth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace stiction {

namespace {

struct Crossing {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};

// Weighted means over what surrounds a vertex.
struct Average {
  double weight = 0.0;
  double depth = 0.0;
  Vec3 normal = Vec3::Zero();

  void add(double w, double d, const Vec3& n) {
    weight += w;
    depth += w * d;
    normal += w * n;
  }
  bool write_to(PairContact& contact) const {
    if (!(weight > 0.0) || !(normal.norm() > 0.0)) return false;
    contact.depth = std::max(0.0, depth / weight);
    contact.normal = normal.normalized();
    return true;
  }
};

// Where the segment p → q leaves the body of `element`, nearest to p; false when it crosses
// nothing.
bool find_crossing(const Topology& topology, const std::vector<Vec3>& x, const Vec3& p,
                   const Vec3& q, std::int32_t element, Crossing& crossing) {
  double first = std::numeric_limits<double>::infinity();
  const auto e = static_cast<std::size_t>(element);
  for (std::int32_t k = topology.near_begin[e]; k < topology.near_begin[e + 1]; ++k) {
    const Topology::Triangle& triangle =
        topology.triangle[static_cast<std::size_t>(topology.near[static_cast<std::size_t>(k)])];
    const Vec3& a = x[static_cast<std::size_t>(triangle.vertex[0])];
    const Vec3 ab = x[static_cast<std::size_t>(triangle.vertex[1])] - a;
    const Vec3 ac = x[static_cast<std::size_t>(triangle.vertex[2])] - a;
    const Vec3 normal = ab.cross(ac);
    const double along = normal.dot(q - p);
    if (!(along > 0.0)) continue;  // only outwards
    const double t = normal.dot(a - p) / along;
    if (t < 0.0 || t > 1.0 || t >= first) continue;
    const Vec3 foot = p + t * (q - p) - a;
    const double v = foot.cross(ac).dot(normal) / normal.squaredNorm();
    const double w = ab.cross(foot).dot(normal) / normal.squaredNorm();
    if (v < 0.0 || w < 0.0 || v + w > 1.0) continue;
    first = t;
    crossing = {p + t * (q - p), normal.normalized()};
  }
  return first <= 1.0;
}

std::size_t find_contact(const PairContacts& pairs, std::int32_t vertex, ContactKey like) {
  const ContactKey key =
      contact_key(static_cast<std::uint32_t>(vertex), static_cast<std::uint32_t>(like));
  const auto at = std::lower_bound(pairs.begin(), pairs.end(), key,
                                   [](const PairContact& c, ContactKey k) { return c.key < k; });
  return at != pairs.end() && at->key == key ? static_cast<std::size_t>(at - pairs.begin())
                                             : pairs.size();
}

}  // namespace

void consistent_depths(const Scene& scene, Workspace& workspace) {
  const Topology& topology = scene.topology;
  const std::vector<Vec3>& x = workspace.search.predicted;
  PairContacts& pairs = workspace.pairs;
  // Levels of the breadth-first search: 0 not reached, 1 border, …
  std::vector<int>& level = workspace.search.level;
  level.assign(pairs.size(), 0);
  const auto neighbours = [&](const PairContact& contact, auto&& use) {
    const auto v = static_cast<std::size_t>(contact.vertex);
    for (std::int32_t k = topology.neighbour_begin[v]; k < topology.neighbour_begin[v + 1]; ++k) {
      use(topology.neighbour[static_cast<std::size_t>(k)]);
    }
  };
  for (std::size_t c = 0; c < pairs.size(); ++c) {
    if (pairs[c].depth == 0.0) continue;
    const Vec3& p = x[static_cast<std::size_t>(pairs[c].vertex)];
    Average average;
    neighbours(pairs[c], [&](std::int32_t other) {
      const std::size_t inside = find_contact(pairs, other, pairs[c].key);
      if (inside < pairs.size() && pairs[inside].depth > 0.0) return;
      Crossing crossing;
      const Vec3& q = x[static_cast<std::size_t>(other)];
      if (!find_crossing(topology, x, p, q, pairs[c].element, crossing)) return;
      const Vec3 away = crossing.point - p;
      // A vertex on the surface itself has an infinite weight; round-off squared bounds it.
      average.add(1.0 / std::max(away.squaredNorm(), 1e-30), away.dot(crossing.normal),
                  crossing.normal);
    });
    if (average.write_to(pairs[c])) level[c] = 1;
  }
  for (int front = 1;; ++front) {
    bool advanced = false;
    for (std::size_t c = 0; c < pairs.size(); ++c) {
      if (level[c] != 0 || pairs[c].depth == 0.0) continue;
      const Vec3& p = x[static_cast<std::size_t>(pairs[c].vertex)];
      Average average;
      neighbours(pairs[c], [&](std::int32_t other) {
        const std::size_t known = find_contact(pairs, other, pairs[c].key);
        if (known == pairs.size() || level[known] == 0 || level[known] > front) return;
        const Vec3 away = x[static_cast<std::size_t>(other)] - p;
        const PairContact& from = pairs[known];
        average.add(1.0 / away.squaredNorm(), away.dot(from.normal) + from.depth, from.normal);
      });
      if (average.write_to(pairs[c])) {
        level[c] = front + 1;
        advanced = true;
      }
    }
    if (!advanced) break;
  }
}

}  // namespace stiction
