// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/edge_pair.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numeric>
#include <vector>

#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

constexpr Real kGap = 1e-4;  // at which contacts are kept, m

// Whether two edges can touch between such ends.
bool can_touch(const Topology& topology, const std::vector<Vec3>& x, std::int32_t a, std::int32_t b,
               const EndMargins& ends) {
  EdgeCrossing crossing;
  if (!crossing_of(topology, x, a, b, crossing) || crossing.gap > kGap) return false;
  const auto inside = [&](std::int32_t e, Real along) {
    const Topology::SharpEdge& edge = topology.sharp_edge[static_cast<std::size_t>(e)];
    return inside_ends(edge, frame_of(x, edge).length, along, ends) >= 0;
  };
  return inside(a, crossing.along_a) && inside(b, crossing.along_b);
}

Vec3 across_both(const Topology& topology, const std::vector<Vec3>& x, std::int32_t a,
                 std::int32_t b) {
  const auto along = [&](std::int32_t e) -> Vec3 {
    const auto& v = topology.sharp_edge[static_cast<std::size_t>(e)].vertex;
    return x[static_cast<std::size_t>(v[1])] - x[static_cast<std::size_t>(v[0])];
  };
  return along(a).cross(along(b));
}

// Moves what a bound says may move, in many directions, and asks again.
TEST(EdgePair, StaysApartWhileNothingMovesAsFarAsItsBound) {
  std::size_t known = 0, apart = 0, known_off = 0, off = 0;
  std::vector<unsigned> seeds(150);
  std::iota(seeds.begin(), seeds.end(), 0U);
  // Of 6000 those in which the most comes of it when a bound is drawn wider.
  seeds.insert(seeds.end(), {533, 654, 671, 815, 998, 1451, 1758, 2708, 2756, 4779, 5261});
  for (const unsigned seed : seeds) {
    if (seed % test::kOneIn != 0) continue;
    const Scene scene = test::rough_blocks(seed);
    const Topology& topology = scene.topology;
    const EndMargins ends{-1e-4, -1e-4};
    std::vector<Vec3> x;
    for (int v = 0; v < scene.vertex_count(); ++v)
      x.push_back(scene.rest_position.col(v).cast<Real>());
    const auto edges = static_cast<std::int32_t>(topology.sharp_edge.size());
    const auto is_of_first = [&](std::int32_t v) { return v < scene.bodies[1].first_vertex; };
    for (std::int32_t a = 0; a < edges; ++a) {
      for (std::int32_t b = a + 1; b < edges; ++b) {
        const auto first = [&](std::int32_t e) {
          return is_of_first(topology.sharp_edge[static_cast<std::size_t>(e)].vertex[0]);
        };
        if (!first(a) || first(b)) continue;
        if (can_touch(topology, x, a, b, ends)) continue;
        ++apart;
        EdgeCrossing crossing;
        const bool stands_off = crossing_of(topology, x, a, b, crossing) && crossing.gap > kGap;
        off += stands_off;
        const Real within = apart_within(topology, x, a, b, ends, kGap);
        if (!(within > 0)) continue;
        ++known;
        known_off += stands_off;
        // And as they come nearest to each other, if they do: both bodies as wholes, across both edges.
        const Vec3 across = across_both(topology, x, a, b).normalized();
        for (unsigned k = 0; k < 15; ++k) {
          Eigen::Matrix3Xd way =
              test::noise(scene.vertex_count(), 1.0, 11 * seed + k).colwise().normalized();
          const double along = k < 9 ? 0.0 : (k < 12 ? 1.0 : -1.0);
          for (std::int32_t v = 0; along != 0.0 && v < scene.vertex_count(); ++v) {
            way.col(v) = (is_of_first(v) ? along : -along) * across.cast<double>();
          }
          const Real share = Real(0.5) * static_cast<Real>(k % 3);
          std::vector<Vec3> moved = x;
          for (std::int32_t v = 0; v < scene.vertex_count(); ++v) {
            const Real by = Real(0.999) * within * (is_of_first(v) ? share : 1 - share);
            moved[static_cast<std::size_t>(v)] += by * way.col(v).cast<Real>();
          }
          EXPECT_FALSE(can_touch(topology, moved, a, b, ends))
              << "seed " << seed << ", edges " << a << " and " << b << ", within " << within;
        }
      }
    }
  }
  EXPECT_GT(known, 3 * apart / 4) << "of " << apart;
  EXPECT_GT(known_off, 9 * off / 10) << "of " << off << " that face each other";
}

}  // namespace
}  // namespace stiction
