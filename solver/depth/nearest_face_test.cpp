// SPDX-License-Identifier: BSD-3-Clause
// The nearest face, held against all triangles one by one and a triangle against samples.
#include "solver/depth/nearest_face.h"

#include <gtest/gtest.h>

#include "solver/depth/nearest.h"
#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

// Nearest point by minimising over a fine grid of weights.
double sampled_distance2(const Vec3& p, const Eigen::Matrix3d& corners, int n) {
  double best = test::kInfinity;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n - i; ++j) {
      const Vec3 weight(i, j, n - i - j);
      best = std::min(best, (corners * weight / n - p).squaredNorm());
    }
  }
  return best;
}

TEST(NearestOnTriangle, IsNeverBeatenBySampling) {
  constexpr int kSamples = 60;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Eigen::Matrix3d corners = test::noise(3, 1.0, seed);
    const Vec3 p = test::noise(1, 1.5, 1000 + seed);
    const NearestOnTriangle nearest =
        nearest_on_triangle(p, corners.col(0), corners.col(1), corners.col(2));
    EXPECT_NEAR(nearest.weight.sum(), 1.0, 1e-14);
    EXPECT_GE(nearest.weight.minCoeff(), 0.0);
    const double sampled = sampled_distance2(p, corners, kSamples);
    EXPECT_LE(nearest.distance2, sampled + 1e-14) << "seed " << seed;
    // A sample lies within an edge/60 of the nearest point.
    EXPECT_GE(std::sqrt(nearest.distance2) + 3.5 / kSamples, std::sqrt(sampled));
  }
}

// The nearest of all triangles of the penetrated body, of equals the lowest number; and how many
// are as near.
struct BruteForce {
  std::int32_t triangle = -1;
  int equals = 0;

  BruteForce(const Topology& topology, const Eigen::Matrix3Xd& x, const PairContact& contact) {
    const auto body = static_cast<std::size_t>(contact.other);
    double least = test::kInfinity;
    for (std::int32_t t = topology.body_triangle_begin[body];
         t < topology.body_triangle_begin[body + 1]; ++t) {
      const auto& v = topology.triangle[static_cast<std::size_t>(t)].vertex;
      const double distance2 =
          nearest_on_triangle(x.col(contact.vertex), x.col(v[0]), x.col(v[1]), x.col(v[2]))
              .distance2;
      if (distance2 > least) continue;
      if (distance2 < least) equals = 0;
      if (distance2 < least) triangle = t;
      least = distance2;
      ++equals;
    }
  }
};

// One body slides off another, along edges between triangles, where equal distances are exactly
// equal, or across them, while the lists of near triangles grow old.
class SlidingContact : public testing::TestWithParam<double> {};

TEST_P(SlidingContact, ProjectsOnTheNearestTriangleAndOfEqualsOnTheLowest) {
  SceneDescription description;
  description.bodies = {test::elastic_body(test::cube_mesh(2)),
                        test::elastic_body(test::cube_mesh(2))};
  description.bodies[1].mesh.vertices.colwise() += Vec3(0.375, GetParam(), 1.0 - 1.0 / 16.0);
  const Scene scene = build_scene(description);
  const Body& upper = scene.bodies[1];
  Options options;
  options.pairs.face = PairFace::kNearest;
  options.pairs.hysteresis = 0.0;
  options.pairs.tie_margin = 0.0;
  Workspace kept;
  int ties = 0, old_lists = 0;
  for (int k = 0; k < 256; ++k) {
    Eigen::Matrix3Xd position = scene.rest_position;
    position.middleCols(upper.first_vertex, upper.vertex_count).row(0).array() -= k / 512.0;
    const State state =
        test::state_at(scene, position, Eigen::Matrix3Xd::Zero(3, scene.vertex_count()));
    kept.velocity = state.velocity;
    detect_pairs(scene, options, state, kept);
    old_lists += kept.search.moved[1] > 0.0 ? 1 : 0;
    depths(scene, options, state, kept);
    EXPECT_GE(kept.pairs.size(), 4u);
    for (const PairContact& contact : kept.pairs) {
      const BruteForce expected(scene.topology, position, contact);
      EXPECT_EQ(kept.pairs.site_of(contact).triangle, expected.triangle)
          << "step " << k << ", vertex " << contact.vertex;
      ties += expected.equals > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(ties, GetParam() == 0.5 ? 256 : 0);
  EXPECT_GT(old_lists, 200);
}

INSTANTIATE_TEST_SUITE_P(Offsets, SlidingContact, testing::Values(0.5, 0.375),
                         [](const auto& one) { return one.param == 0.5 ? "Along" : "Across"; });

// However deep: of the triangles near its element none may be the nearest.
TEST(NearestFace, OfDeepPointsIsThatOfTheWholeSurface) {
  SceneDescription description;
  TetMesh block = test::cube_mesh(6);
  block.vertices += test::noise(block.vertices.cols(), 0.02, 1);
  description.bodies = {test::elastic_body(std::move(block)),
                        test::point_masses(0.8 * test::noise(400, 0.5, 2), 1.0)};
  description.bodies[1].mesh.vertices.array() += 0.5;
  const Scene scene = build_scene(description);
  Options options;
  options.pairs.hysteresis = 0.0;
  const test::Found found(scene, options, initial_state(scene));
  ASSERT_GT(found.workspace.pairs.size(), 380u);
  const PairContacts& pairs = found.workspace.pairs;
  for (const PairContact& contact : pairs) {
    EXPECT_EQ(pairs.site_of(contact).triangle,
              BruteForce(scene.topology, scene.rest_position, contact).triangle);
  }
}

}  // namespace
}  // namespace stiction
