// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/crossing_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <vector>

#include "solver/observables.h"
#include "solver/step.h"
#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

// A bar of 4 × 1 × 1 cells of edge 0.1 m about `centre`, turned about the vertical.
BodyDescription bar(const Vec3& centre, double yaw) {
  TetMesh mesh = test::cube_mesh(1, 0.1);
  TetMesh all;
  for (int k = 0; k < 4; ++k) {
    const Eigen::Index first = all.vertices.cols();
    all.vertices.conservativeResize(3, first + 8);
    all.vertices.rightCols(8) = mesh.vertices.colwise() + Vec3(0.1 * k, 0.0, 0.0);
    const Eigen::Index element = all.tetrahedra.cols();
    all.tetrahedra.conservativeResize(4, element + 6);
    all.tetrahedra.rightCols(6) = mesh.tetrahedra.array() + static_cast<int>(first);
  }
  // One vertex where two cells meet.
  std::vector<int> number(static_cast<std::size_t>(all.vertices.cols()));
  Eigen::Matrix3Xd distinct(3, 0);
  for (Eigen::Index v = 0; v < all.vertices.cols(); ++v) {
    Eigen::Index same = 0;
    while (same < distinct.cols() && (distinct.col(same) - all.vertices.col(v)).norm() > 1e-9) {
      ++same;
    }
    if (same == distinct.cols()) {
      distinct.conservativeResize(3, same + 1);
      distinct.col(same) = all.vertices.col(v);
    }
    number[static_cast<std::size_t>(v)] = static_cast<int>(same);
  }
  for (int& v : all.tetrahedra.reshaped()) v = number[static_cast<std::size_t>(v)];
  all.vertices = distinct.colwise() - Vec3(0.2, 0.05, 0.05);
  all.vertices = (Eigen::AngleAxisd(yaw, Vec3::UnitZ()).toRotationMatrix() * all.vertices).eval();
  all.vertices.colwise() += centre;
  return test::elastic_body(all, {.youngs_modulus = 1e6, .damping_time = 1e-3});
}

// The upper of two bars reaches `depth` into the lower one.
Scene crossed(double yaw, double depth, double shift = 0.013) {
  SceneDescription description;
  description.bodies = {bar(Vec3::Zero(), 0.0), bar(Vec3(shift, 0.0, 0.1 - depth), yaw)};
  description.friction = 0.5;
  return build_scene(description);
}

EdgeContacts edges_of(const Scene& scene, const Options& options = {}) {
  test::Found found(scene, options, initial_state(scene));
  crossing_edges(scene, options, found.state, found.workspace);
  return found.workspace.edges;
}

TEST(SharpEdges, OfABarAreItsTwelveSidesAndTheirJoints) {
  const Scene scene = crossed(0.0, 0.0);
  // Four long edges of four cells and eight short ones a bar.
  ASSERT_EQ(scene.topology.sharp_edge.size(), 2u * (4 * 4 + 8));
  int joints = 0;
  for (const auto& edge : scene.topology.sharp_edge) joints += edge.goes_on[0] + edge.goes_on[1];
  EXPECT_EQ(joints, 2 * 4 * 3 * 2);
}

class CrossedBars : public testing::TestWithParam<double> {};

TEST_P(CrossedBars, TouchAtTheFourCornersOfTheirOverlap) {
  const double yaw = GetParam() * std::numbers::pi / 180.0, depth = 1e-4;
  const Scene scene = crossed(yaw, depth);
  const EdgeContacts edges = edges_of(scene);
  ASSERT_EQ(edges.size(), 4u);
  for (const EdgeContact& contact : edges) {
    EXPECT_LT((contact.normal + Vec3::UnitZ()).norm(), 1e-12) << "out of the upper bar";
    EXPECT_NEAR(contact.depth, depth, 1e-15);
    EXPECT_NEAR(contact.own_weight[0] + contact.own_weight[1], 1.0, 1e-15);
    EXPECT_NEAR(contact.weight[0] + contact.weight[1] + contact.weight[2] + contact.weight[3], 1.0,
                1e-14);
    Vec3 arm = Vec3::Zero();
    for (int k = 0; k < 2; ++k) {
      arm += contact.own_weight[k] * scene.rest_position.col(contact.vertex[k]);
    }
    for (int k = 0; k < 4; ++k) {
      arm -= contact.weight[k] * scene.rest_position.col(contact.partner[k]);
    }
    EXPECT_LT(arm.norm(), 1e-15) << "force and reaction act at one point";
  }
}

TEST_P(CrossedBars, DoNotTouchApartOrTurnedOff) {
  const double yaw = GetParam() * std::numbers::pi / 180.0;
  EXPECT_TRUE(edges_of(crossed(yaw, -1e-9)).empty());
  Options off;
  off.pairs.edges = false;
  EXPECT_FALSE(with_edges(off));
  Options paper;
  paper.pairs.gain = NormalGain::kPaper;
  EXPECT_FALSE(with_edges(paper)) << "the paper's gain knows no edges";
}

TEST_P(CrossedBars, ConserveMomentumWhenTheyCollide) {
  Scene scene = crossed(GetParam() * std::numbers::pi / 180.0, -1e-4);
  for (int v = scene.bodies[1].first_vertex; v < scene.vertex_count(); ++v) {
    scene.initial_velocity.col(v) = Vec3(0.2, 0.1, -0.5);
  }
  State state = initial_state(scene);
  const Vec3 linear = linear_momentum(scene, state), angular = angular_momentum(scene, state);
  Workspace workspace;
  const Options options{.time_step = 1e-4};
  std::size_t touched = 0;
  for (int k = 0; k < 200; ++k) {
    step(scene, options, state, workspace);
    touched = std::max(touched, workspace.edges.size());
  }
  EXPECT_EQ(touched, 4u);
  // 200 steps of some 60 roundings of momenta of 2 kg m/s and 0.5 kg m²/s.
  EXPECT_LT((linear_momentum(scene, state) - linear).norm(), 1e-12);
  EXPECT_LT((angular_momentum(scene, state) - angular).norm(), 1e-12);
  EXPECT_GT(centre_velocity(scene, state, scene.bodies[1]).z(), -0.3) << "they push each other";
}

INSTANTIATE_TEST_SUITE_P(Yaws, CrossedBars, testing::Values(90.0, 75.0, 60.0, 45.0));

TEST(CrossingEdges, AreFoundExactlyAtAJoint) {
  // The upper bar's edges pass over the joints of the lower one at x = ±0.05 m exactly.
  SceneDescription description;
  description.bodies = {bar(Vec3::Zero(), 0.0),
                        bar(Vec3(0.05, 0.0, 0.1 - 1e-4), std::numbers::pi / 2)};
  const EdgeContacts edges = edges_of(build_scene(description));
  EXPECT_GE(edges.size(), 4u);
}

TEST(CrossingEdges, AreNotWhereABodyPassesOverAnothersCorner) {
  // The upper bar cuts the corner of the lower one by 0.2 mm, pressed 0.1 mm into it: of the edges
  // that cross there, those that push sideways do not count.
  SceneDescription description;
  const double reach = 2e-4;
  description.bodies = {
      bar(Vec3::Zero(), 0.0),
      bar(Vec3(0.2, 0.05, 0.1 - 1e-4) + (0.05 - reach) * Vec3(1.0, 1.0, 0.0).normalized(),
          -std::numbers::pi / 4)};
  for (const EdgeContact& contact : edges_of(build_scene(description))) {
    EXPECT_GT(std::abs(contact.normal.z()), 0.9);
  }
}

// A cube stands on an edge across the lower bar, 0.1 mm above it or within: the edge reaches 0.2 mm
// beyond either side of the bar, so that no vertex lies over it and both crossings are near
// corners.
EdgeContacts edge_on_bar(double depth, const Vec3& velocity) {
  TetMesh cube = test::cube_mesh(1, 0.1);
  cube.vertices.colwise() -= Vec3::Constant(0.05);
  cube.vertices.row(1) *= 1.004;
  cube.vertices =
      (Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitY()).toRotationMatrix() * cube.vertices)
          .eval();
  cube.vertices.colwise() += Vec3(0.013, 0.0, 0.05 + 0.05 * std::numbers::sqrt2 - depth);
  SceneDescription description;
  description.bodies = {bar(Vec3::Zero(), 0.0), test::elastic_body(cube)};
  Scene scene = build_scene(description);
  for (int v = scene.bodies[1].first_vertex; v < scene.vertex_count(); ++v) {
    scene.initial_velocity.col(v) = velocity;
  }
  return edges_of(scene, {.time_step = 2e-4});
}

TEST(CrossingEdges, NearACornerAreThoseThatHaveComeIn) {
  EXPECT_EQ(edge_on_bar(-1e-4, -Vec3::UnitZ()).size(), 2u) << "0.2 mm of way, onto the bar";
  EXPECT_TRUE(edge_on_bar(3e-4, -Vec3::UnitZ()).empty()) << "deeper than it has come";
  EXPECT_TRUE(edge_on_bar(1e-4, Vec3::UnitY()).empty()) << "it slides along itself";
}

TEST(CrossingEdges, NearACornerAreThoseThatAreShallow) {
  EXPECT_EQ(edge_on_bar(1e-6, Vec3::Zero()).size(), 2u) << "0.2 mm from the corners, 1 µm deep";
  EXPECT_EQ(edge_on_bar(1e-6, 0.1 * Vec3::UnitY()).size(), 2u) << "however it moves";
}

// Two crossed bars go their ways and tremble, or set out of a sudden: pairs of edges that are known not to
// touch are not looked at, some not even in passing, and what is found is what fresh lists find.
TEST(CrossingEdges, AreThoseOfFreshListsWhereSomeAreKnownNotToTouch) {
  std::size_t known = 0, found = 0, asleep = 0, tried = 0;
  const auto go = [&](double yaw, double depth, const Vec3& way, double tremble, bool suddenly) {
    if (++tried % test::kOneIn != 0) return;
    const Scene scene = crossed(yaw, depth);
    const Options options;
    Workspace kept;
    std::vector<ContactKey> last;
    for (unsigned k = 0; k < 150; ++k) {
      const unsigned ways = !suddenly ? k : k < 75 ? (k + 3) / 8 : 4 * k - 291;
      State state = test::on_its_way(scene, ways, way, tremble);
      state.edge_friction.key = last;
      for (const PairSearch::EdgePair& pair : kept.search.edge_candidate) {
        known += pair.apart_until > kept.search.path[0] + kept.search.path[1];
      }
      Workspace fresh;
      for (Workspace* workspace : {&kept, &fresh}) {
        workspace->velocity = state.velocity;
        detect_pairs(scene, options, state, *workspace);
        depths(scene, options, state, *workspace);
        crossing_edges(scene, options, state, *workspace);
      }
      last.clear();
      ASSERT_EQ(kept.edges.size(), fresh.edges.size()) << "step " << k;
      for (std::size_t c = 0; c < kept.edges.size(); ++c) {
        EXPECT_EQ(kept.edges[c].key, fresh.edges[c].key);
        EXPECT_EQ(kept.edges[c].depth, fresh.edges[c].depth);
        EXPECT_EQ(kept.edges[c].normal, fresh.edges[c].normal);
        last.push_back(kept.edges[c].key);
      }
      found += kept.edges.size();
      asleep += kept.search.edge_candidate.size() - kept.search.edge_awake.place.size();
    }
  };
  for (const double yaw : {0.2, 0.8, 1.5707}) {
    for (const Vec3& way : {Vec3(0, 0, 0), Vec3(2e-6, 1e-6, -1e-6), Vec3(3e-4, 2e-4, 0),
                            Vec3(-5e-4, 0, 1e-6), Vec3(0, 0, -2e-5), Vec3(0, 0, 1e-6)}) {
      for (const double tremble : {0.0, 1e-8, 1e-5}) {
        go(yaw, 1e-5, way, tremble, false);
        go(yaw, 1e-5, way, tremble, true);
      }
    }
    for (const double above : {2e-4, 2.5e-4, 3e-4, 3.5e-4, 4e-4}) {  // and come down
      go(yaw, -above, Vec3(0, 0, -2e-5), 0.0, false);
      go(yaw, -above, Vec3(0, 0, -2e-5), 0.0, true);
    }
  }
  EXPECT_GT(known, 10000 / test::kOneIn);
  EXPECT_GT(asleep, 10000 / test::kOneIn);
  EXPECT_GT(found, 1000 / test::kOneIn);
}

// Where a corner is, a crossing that another one outdoes, sharing an edge with it, is no contact.
TEST(CrossingEdges, OfOneEdgeWithABodyInTwoDirectionsTheShallowerCounts) {
  std::size_t by_a = 0, by_b = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    const Scene scene = test::rough_blocks(seed, 0.003);
    test::Found found(scene, {}, initial_state(scene));
    // As if all had touched before: then depth and corners don't count.
    for (const PairSearch::EdgePair& pair : found.workspace.search.edge_candidate) {
      found.state.edge_friction.key.push_back(pair.key);
    }
    crossing_edges(scene, {}, found.state, found.workspace);
    // Once more, after a step in which as many others touched.
    PairSearch& search = found.workspace.search;
    search.touch_key.assign(search.touch_key.size(), 0);
    std::iota(search.touch_by_b.begin(), search.touch_by_b.end(), 0);
    crossing_edges(scene, {}, found.state, found.workspace);
    const std::vector<PairSearch::EdgeTouch>& all = found.workspace.search.edge_touch;
    for (const PairSearch::EdgeTouch& touch : all) {
      bool outdone = false;
      // There are two bodies: an edge that is shared is shared with the same one.
      for (const PairSearch::EdgeTouch& other : all) {
        if (!(other.crossing.gap > touch.crossing.gap)) continue;
        if (!(other.crossing.normal.dot(touch.crossing.normal) < 0.5)) continue;
        const bool a = first_of(other.key) == first_of(touch.key);
        const bool b = second_of(other.key) == second_of(touch.key);
        outdone = outdone || a || b;
        by_a += a;
        by_b += b;
      }
      EXPECT_EQ(touch.outdone, outdone) << "seed " << seed;
      EXPECT_EQ(std::count_if(found.workspace.edges.begin(), found.workspace.edges.end(),
                              [&](const EdgeContact& one) { return one.key == touch.key; }),
                outdone ? 0 : 1);
    }
  }
  EXPECT_GT(by_a, 100u);
  EXPECT_GT(by_b, 5u);
}

}  // namespace
}  // namespace stiction
