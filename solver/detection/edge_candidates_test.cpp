// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/edge_candidates.h"

#include <gtest/gtest.h>

#include <vector>

#include "solver/detection/pair_candidates.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

// What is known of a pair of edges, as a search may have left it.
constexpr double kKnown = 7.0;

class EdgeCandidates : public testing::Test {
 protected:
  static constexpr int kBodies = 6;

  EdgeCandidates() {
    SceneDescription description;
    for (int k = 0; k < kBodies; ++k) {
      BodyDescription body = test::elastic_body(test::cube_mesh(1 + k % 2));
      // In a row, each a little over the one before it, so that bodies not next to each other don't meet.
      body.mesh.vertices.colwise() += Eigen::Vector3d(0.95 * k, 0.1 * k, -0.05 * k);
      if (k < 2) {  // two that can't come to touch each other
        for (int v = 0; v < body.mesh.vertices.cols(); ++v) body.pinned.push_back(v);
      }
      description.bodies.push_back(body);
    }
    scene = build_scene(description);
    state = initial_state(scene);
    velocity.resize(state.position.size());
  }

  // Carries a body so far, m, and lists what that changes.
  void move(std::size_t body, const Vec3& by) {
    const Body& moved = scene.bodies[body];
    for (int v = moved.first_vertex; v < moved.first_vertex + moved.vertex_count; ++v) {
      state.position[static_cast<std::size_t>(v)].x += by;
    }
    if (update_candidates(scene, 1e-3, state, velocity, nullptr, search)) {
      find_edge_candidates(scene, search);
    }
  }

  std::vector<ContactKey> listed() const {
    std::vector<ContactKey> keys;
    for (const PairSearch::EdgePair& pair : search.edge_candidate) keys.push_back(pair.key);
    return keys;
  }

  // By comparing each with each.
  std::vector<ContactKey> expected() const {
    const auto& edges = scene.topology.sharp_edge;
    const auto body = [&](std::size_t e) {
      return static_cast<std::size_t>(
          scene.topology.vertex_body[static_cast<std::size_t>(edges[e].vertex[0])]);
    };
    const auto box = [&](std::size_t e) {
      Box3 ends(search.reference[static_cast<std::size_t>(edges[e].vertex[0])]);
      ends.extend(search.reference[static_cast<std::size_t>(edges[e].vertex[1])]);
      return Box3(ends.min() - Vec3::Constant(2 * search.skin),
                  ends.max() + Vec3::Constant(2 * search.skin));
    };
    std::vector<ContactKey> keys;
    for (std::size_t a = 0; a < edges.size(); ++a) {
      for (std::size_t b = a + 1; b < edges.size(); ++b) {
        if (body(a) == body(b) || !box(a).intersects(box(b))) continue;
        if (scene.bodies[body(a)].fixed && scene.bodies[body(b)].fixed) continue;
        keys.push_back(contact_key(static_cast<int>(a), static_cast<int>(b)));
      }
    }
    return keys;
  }

  Scene scene;
  State state;
  std::vector<Velocity> velocity;
  PairSearch search;
};

TEST_F(EdgeCandidates, AreAllWhoseBoxesMeet) {
  const Eigen::Matrix3Xd ways = test::noise(40, 0.15, 5);
  std::size_t least = 1000, most = 0;
  for (int k = 0; k < ways.cols(); ++k) {
    const Vec3 before = k < kBodies ? Vec3(Vec3::Zero()) : Vec3(ways.col(k - kBodies));
    move(static_cast<std::size_t>(k % kBodies), ways.col(k) - before);
    EXPECT_EQ(listed(), expected()) << "after move " << k;
    least = std::min(least, listed().size());
    most = std::max(most, listed().size());
  }
  EXPECT_GT(least, 20u);
  EXPECT_GT(most, least);
}

TEST_F(EdgeCandidates, KeepWhatIsKnownOfBodiesThatStay) {
  move(0, Vec3::Zero());
  for (PairSearch::EdgePair& pair : search.edge_candidate) pair.apart_until = kKnown;
  move(3, {0.2, 0.0, 0.0});
  std::size_t kept = 0, anew = 0;
  for (const PairSearch::EdgePair& pair : search.edge_candidate) {
    const bool moved = pair.body_a == 3 || pair.body_b == 3;
    EXPECT_EQ(pair.apart_until == kKnown, !moved) << pair.body_a << " and " << pair.body_b;
    ++(moved ? anew : kept);
  }
  EXPECT_GT(kept, 10u);
  EXPECT_GT(anew, 10u);
}

// As where a step without edges, or with other options, came between.
TEST_F(EdgeCandidates, AreListedAnewWhereTheyWereNot) {
  move(0, Vec3::Zero());
  for (PairSearch::EdgePair& pair : search.edge_candidate) pair.apart_until = kKnown;
  search.edges_listed = false;
  move(3, {0.2, 0.0, 0.0});
  EXPECT_EQ(listed(), expected());
  for (const PairSearch::EdgePair& pair : search.edge_candidate) {
    EXPECT_NE(pair.apart_until, kKnown);
  }
}

}  // namespace
}  // namespace stiction
