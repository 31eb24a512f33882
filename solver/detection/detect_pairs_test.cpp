// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/detect_pairs.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <iterator>
#include <set>

#include "solver/depth/remember_pairs.h"
#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

// The slow twin: every surface vertex against every tetrahedron of the other bodies.
std::set<ContactKey> brute_force(const Scene& scene, const State& state) {
  const auto x = [&](int v) { return state.position[static_cast<std::size_t>(v)].x; };
  std::set<ContactKey> keys;
  for (const int v : scene.surface_vertex) {
    const int own = scene.topology.vertex_body[static_cast<std::size_t>(v)];
    for (std::size_t e = 0; e < scene.elements.size(); ++e) {
      const int body = scene.topology.element_body[e];
      if (body == own) continue;
      const auto& corner = scene.elements[e].vertex;
      const Eigen::Vector4d weight =
          barycentric(x(v), x(corner[0]), x(corner[1]), x(corner[2]), x(corner[3]));
      if (weight.minCoeff() >= 0.0) {
        keys.insert(contact_key(v, body));
      }
    }
  }
  return keys;
}

std::set<ContactKey> found(const Scene& scene, const State& state) {
  Workspace workspace;
  workspace.velocity = state.velocity;
  Options options;
  options.pairs.hysteresis = 0.0;
  detect_pairs(scene, options, state, workspace);
  std::set<ContactKey> keys;
  for (const PairContact& contact : workspace.pairs) keys.insert(contact.key());
  EXPECT_EQ(keys.size(), workspace.pairs.size()) << "one contact a vertex and body";
  return keys;
}

// Finds and measures the contacts of a state with the lists that a workspace has kept and with fresh ones:
// they are the same.
void expect_what_fresh_lists_find(const Scene& scene, const Options& options, const State& state,
                                  Workspace& kept) {
  Workspace fresh;
  for (Workspace* workspace : {&kept, &fresh}) {
    workspace->velocity = state.velocity;
    detect_pairs(scene, options, state, *workspace);
    depths(scene, options, state, *workspace);
  }
  ASSERT_EQ(kept.pairs.size(), fresh.pairs.size());
  for (std::size_t c = 0; c < kept.pairs.size(); ++c) {
    EXPECT_EQ(kept.pairs[c].key(), fresh.pairs[c].key());
    EXPECT_EQ(kept.pairs.site(c).element, fresh.pairs.site(c).element);
    EXPECT_EQ(kept.pairs.site(c).triangle, fresh.pairs.site(c).triangle);
    EXPECT_EQ(kept.pairs[c].depth, fresh.pairs[c].depth);
    EXPECT_EQ(kept.pairs[c].normal, fresh.pairs[c].normal);
  }
}

State at_rest_at(const Scene& scene, const Eigen::Matrix3Xd& position) {
  return test::state_at(scene, position, Eigen::Matrix3Xd::Zero(3, scene.vertex_count()));
}

TEST(Barycentric, WeightsGiveThePointBackAndSumToOne) {
  const Eigen::Matrix3Xd x = test::noise(5, 1.0, 3);
  const Eigen::Vector4d weight = barycentric(x.col(4), x.col(0), x.col(1), x.col(2), x.col(3));
  // A handful of roundings of numbers of order one over a volume of order 0.1.
  EXPECT_NEAR(weight.sum(), 1.0, 1e-14);
  EXPECT_LT((x.leftCols<4>() * weight - x.col(4)).norm(), 1e-13);
}

TEST(DetectPairs, FindsWhatBruteForceFindsInTumbledDeformedBodies) {
  std::size_t contacts = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SceneDescription description = test::stacked_cubes(0.3);
    const Vec3 axis = test::noise(1, 1.0, 100 + seed);
    const Mat3 turn = Eigen::AngleAxisd(0.3 * seed, axis.normalized()).toRotationMatrix();
    const Vec3 place = Vec3(0.5, 0.5, 1.1) + 0.3 * axis;
    Eigen::Matrix3Xd& upper = description.bodies[1].mesh.vertices;
    for (Eigen::Index v = 0; v < upper.cols(); ++v) {
      upper.col(v) = (turn * (upper.col(v) - Vec3(0.71, 0.63, 1.2)) + place).eval();
    }
    const Scene scene = build_scene(description);
    const State state = test::state_at(
        scene, scene.rest_position + test::noise(scene.vertex_count(), 0.03, 200 + seed),
        Eigen::Matrix3Xd::Zero(3, scene.vertex_count()));
    const std::set<ContactKey> expected = brute_force(scene, state);
    EXPECT_EQ(found(scene, state), expected) << "seed " << seed;
    contacts += expected.size();
  }
  EXPECT_GT(contacts, 100u) << "the configurations do touch";
}

// Three bodies in one place: a vertex may be in both others.
TEST(DetectPairs, FindsAVertexInEachBodyThatItIsIn) {
  std::size_t in_two = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    SceneDescription description = test::stacked_cubes(0.3);
    description.bodies.push_back(description.bodies[0]);
    unsigned turn = 0;
    for (BodyDescription& body : description.bodies) {
      const Vec3 place = test::noise(1, 0.3, 10 * seed + turn++);
      body.mesh.vertices.colwise() += place - body.mesh.vertices.rowwise().mean();
      body.mesh.vertices += test::noise(body.mesh.vertices.cols(), 0.02, 500 + seed);
    }
    const Scene scene = build_scene(description);
    const State state = at_rest_at(scene, scene.rest_position);
    const std::set<ContactKey> expected = brute_force(scene, state);
    EXPECT_EQ(found(scene, state), expected) << "seed " << seed;
    for (auto key = expected.begin(); key != expected.end(); ++key) {
      in_two += std::next(key) != expected.end() && first_of(*std::next(key)) == first_of(*key);
    }
  }
  EXPECT_GT(in_two, 10u);
}

// One body passes through another while the lists of candidates go stale and are renewed; each time
// what is found is what fresh lists find.
TEST(DetectPairs, FindsTheSameWhenItsListsWereMadeForEarlierPositions) {
  const Scene scene = build_scene(test::stacked_cubes(0.2));
  const Body& upper = scene.bodies[1];
  Workspace kept;
  Options options;
  options.pairs.hysteresis = 0.0;
  std::size_t renewed = 0, contacts = 0;
  for (int k = 0; k < 200; ++k) {
    Eigen::Matrix3Xd position = scene.rest_position + test::noise(scene.vertex_count(), 0.004,
                                                                  300 + static_cast<unsigned>(k));
    position.middleCols(upper.first_vertex, upper.vertex_count).colwise() +=
        0.004 * k * Vec3(0.3, -0.2, -1.0);
    const std::vector<Vec3> before = kept.search.reference;
    SCOPED_TRACE(k);
    expect_what_fresh_lists_find(scene, options, at_rest_at(scene, position), kept);
    if (before != kept.search.reference) ++renewed;
    contacts += kept.pairs.size();
  }
  EXPECT_GT(contacts, 200u * 10u) << "the bodies touch all the time";
  EXPECT_GT(renewed, 10u) << "the lists were renewed";
  EXPECT_LT(renewed, 100u) << "and served several steps";
}

// A cube comes down on another in steps far below the skin, trembling, and goes up again: vertices that
// are known to be clear of the other are not looked at, and none is missed that comes in.
TEST(DetectPairs, LooksAtNoVertexThatIsKnownToBeClearAndMissesNoneThatComesIn) {
  for (const double tremble : {0.0, 1e-5, 1e-3}) {
    const Scene scene = build_scene(test::stacked_cubes(-0.012));
    const Body& upper = scene.bodies[1];
    Workspace kept;
    Options options;
    options.pairs.hysteresis = 0.0;
    std::size_t clear = 0, none = 0, most = 0;
    for (int k = 0; k < 400; ++k) {
      Eigen::Matrix3Xd position = scene.rest_position + test::noise(scene.vertex_count(), tremble,
                                                                    900 + static_cast<unsigned>(k));
      position.middleCols(upper.first_vertex, upper.vertex_count).colwise() -=
          1e-4 * std::min(k, 400 - k) * Vec3(0.1, 0.0, 1.0);
      SCOPED_TRACE(k);
      expect_what_fresh_lists_find(scene, options, at_rest_at(scene, position), kept);
      for (const PairSearch::Group& group : kept.search.group) {
        clear +=
            group.verdict == -1 && group.holds_until > kept.search.path[0] + kept.search.path[1];
      }
      none += kept.pairs.empty();
      most = std::max(most, kept.pairs.size());
    }
    EXPECT_GT(none, 50u) << "at first and at last they are apart";
    EXPECT_GT(most, 8u) << "in between they touch";
    if (tremble < 1e-4) {
      EXPECT_GT(clear, 400u) << "some are known to be clear";
    }
  }
}

// A cube stands on another, goes its way, steadily or of a sudden, and trembles. Where it is known that the same
// element goes on holding a vertex, or that none does, no test is made, and what is found is what fresh lists find.
TEST(DetectPairs, KnowsForHowLongAVertexIsHeldOrOpen) {
  std::size_t held = 0, open = 0, asleep = 0, tried = 0;
  const auto go = [&](double depth, double tie_margin, const Vec3& way, double tremble,
                      bool suddenly, double hysteresis = 4.0) {
    if (++tried % test::kOneIn != 0) return;
    SceneDescription description = test::stacked_cubes(depth, Vec3(0.15, 0.0, 0.0));
    description.gravity = {{0.0}, {Vec3(0, 0, -9.81)}};
    const Scene scene = build_scene(description);
    Workspace kept;
    Options options;
    options.pairs.hysteresis = hysteresis;
    options.pairs.tie_margin = tie_margin;
    PairGeometry memory, earlier;
    for (unsigned k = 0; k < 300; ++k) {
      if (k % 50 == 20) earlier = memory;
      if (k % 50 == 45) memory = earlier;
      SCOPED_TRACE(testing::Message() << depth << ", " << way.transpose() << ", " << tremble
                                      << (suddenly ? ", suddenly" : "") << ", step " << k);
      const unsigned ways = !suddenly ? k : k < 200 ? (k + 3) / 8 : 4 * k - 775;
      State state = test::on_its_way(scene, ways, way, tremble);
      state.pair_geometry = memory;
      for (const PairSearch::Group& group : kept.search.group) {
        if (group.holds_until > kept.search.path[0] + kept.search.path[1]) {
          held += group.verdict >= 0;
          open += group.verdict < -1;
        }
      }
      expect_what_fresh_lists_find(scene, options, state, kept);
      if (testing::Test::HasFailure()) return;
      if (kept.search.found_same) {
        asleep += kept.search.group.size() - kept.search.group_awake.place.size();
      }
      remember_pairs(kept.pairs, scene.topology, memory);
      PairGeometry afresh;
      PairContacts copy = kept.pairs;
      remember_pairs(copy, scene.topology, afresh);
      ASSERT_EQ(memory.body_key, afresh.body_key);
      ASSERT_EQ(memory.element, afresh.element);
      ASSERT_EQ(memory.triangle, afresh.triangle);
    }
  };
  for (const auto& [depth, tie_margin] :
       {std::pair(3e-7, 1e-3), std::pair(1e-3, 1e-3), std::pair(1e-3, 0.9)}) {
    for (const Vec3& way :
         {Vec3(0, 0, 0), Vec3(1e-6, 0, 0), Vec3(2e-4, -1e-4, 0), Vec3(1e-3, 0, 1e-8),
          Vec3(1.3e-3, 5e-4, 0), Vec3(0, 0, 1e-8), Vec3(0, 0, -1e-6), Vec3(0, 0, 2e-5)}) {
      for (const double tremble : {0.0, 1e-10, 1e-7, 1e-4}) {
        go(depth, tie_margin, way, tremble, false);
        go(depth, tie_margin, way, tremble, true);
        if (HasFailure()) return;
      }
    }
  }
  // Vertices come in where others go out, in the same step.
  for (const double way : {1e-3, 0.01, 0.02, 0.05, 0.1}) {
    go(1e-3, 1e-3, Vec3(way, 0.4 * way, 0), 0.0, false, 0.0);
    go(1e-6, 1e-3, Vec3(0, 0, 0), 3e-6, false, 0.0);
    if (HasFailure()) return;
  }
  EXPECT_GT(held, 10000 / test::kOneIn);
  EXPECT_GT(open, 1000 / test::kOneIn);
  EXPECT_GT(asleep, 10000 / test::kOneIn);
}

// Of four cubes on each other one after the other moves: lists of the others stay, and each time what
// is found is what fresh lists find.
TEST(DetectPairs, MakesNewListsOfTheBodiesThatMoveAlone) {
  SceneDescription description = test::stacked_cubes(0.05);
  for (const double height : {1.9, 2.85}) {
    description.bodies.push_back(description.bodies[0]);
    description.bodies.back().mesh.vertices.row(2).array() += height;
  }
  const Scene scene = build_scene(description);
  Workspace kept;
  Options options;
  Eigen::Matrix3Xd position = scene.rest_position.cast<double>();
  std::size_t contacts = 0;
  for (unsigned k = 0; k < 60; ++k) {
    const Body& body = scene.bodies[k % 4];
    position.middleCols(body.first_vertex, body.vertex_count).colwise() +=
        Eigen::Vector3d(test::noise(1, 0.06, 500 + k).col(0));
    const std::vector<Vec3> before = kept.search.reference;
    SCOPED_TRACE(k);
    expect_what_fresh_lists_find(scene, options, at_rest_at(scene, position), kept);
    for (std::size_t v = 0; k > 0 && v < before.size(); ++v) {
      if (before[v] == kept.search.reference[v]) continue;
      EXPECT_EQ(scene.topology.vertex_body[v], static_cast<int>(k % 4));
    }
    contacts += kept.pairs.size();
  }
  EXPECT_GT(contacts, 60u * 10u) << "the bodies touch all the time";
}

// The lower cube moves where it meets nothing, and the upper one follows: what was known of the lower one
// where it was is not taken for what it is.
TEST(DetectPairs, KnowsABodyThatMovedWhereItMetNothing) {
  const Scene scene = build_scene(test::stacked_cubes(0.1));
  const Eigen::Vector3d away(7.0, 0.0, 0.0);
  Workspace kept;
  Options options;
  Eigen::Matrix3Xd position = scene.rest_position.cast<double>();
  for (const int mover : {-1, 0, 1}) {
    if (mover >= 0) {
      const Body& body = scene.bodies[static_cast<std::size_t>(mover)];
      position.middleCols(body.first_vertex, body.vertex_count).colwise() += away;
    }
    SCOPED_TRACE(mover);
    expect_what_fresh_lists_find(scene, options, at_rest_at(scene, position), kept);
    EXPECT_EQ(kept.pairs.empty(), mover == 0);
  }
  Workspace fresh;
  expect_what_fresh_lists_find(scene, options, at_rest_at(scene, position), fresh);
  for (std::size_t t = 0; t < kept.search.ball.size(); ++t) {
    EXPECT_EQ(kept.search.ball[t].centre, fresh.search.ball[t].centre) << "triangle " << t;
  }
}

TEST(DetectPairs, MakesNewListsForAnotherScene) {
  const Scene apart = build_scene(test::stacked_cubes(-0.5));
  const Scene touching = build_scene(test::stacked_cubes(0.1));
  Workspace workspace;
  for (const Scene* scene : {&apart, &touching}) {
    const State state = initial_state(*scene);
    workspace.velocity = state.velocity;
    detect_pairs(*scene, {}, state, workspace);
  }
  EXPECT_FALSE(workspace.pairs.empty());
}

TEST(DetectPairs, LooksAtThePredictedPositions) {
  const Scene scene = build_scene(test::stacked_cubes(-0.1));
  State state = initial_state(scene);
  EXPECT_TRUE(found(scene, state).empty());
  const Body& upper = scene.bodies[1];
  for (int v = upper.first_vertex; v < upper.first_vertex + upper.vertex_count; ++v) {
    state.velocity[static_cast<std::size_t>(v)].v = Vec3(0.0, 0.0, -0.2 / Options{}.time_step);
  }
  EXPECT_FALSE(found(scene, state).empty());
}

TEST(DetectPairs, OrdersContactsByVertexThenBody) {
  const Scene scene = build_scene(test::stacked_cubes(0.1));
  const test::Found all(scene, {}, initial_state(scene));
  ASSERT_GT(all.workspace.pairs.size(), 4u);
  for (std::size_t c = 1; c < all.workspace.pairs.size(); ++c) {
    EXPECT_LT(all.workspace.pairs[c - 1].key(), all.workspace.pairs[c].key());
  }
}

// A cube folded so that one corner lies inside it, touches itself only where that is asked for.
TEST(DetectPairs, FindsSelfContactOnlyWhereTheSceneAsksForIt) {
  SceneDescription description = test::one_body(test::elastic_body(test::cube_mesh(3)));
  for (const bool asked : {false, true}) {
    description.bodies[0].self_collision = asked;
    const Scene scene = build_scene(description);
    EXPECT_EQ(scene.pairs_possible, asked);
    if (!asked) continue;
    State state = initial_state(scene);
    for (Position& p : state.position) {
      if ((p.x - Vec3(1, 1, 1)).norm() < 1e-12) p.x = Vec3(0.2, 0.15, 0.1);
    }
    EXPECT_FALSE(found(scene, state).empty());
  }
}

TEST(DetectPairs, NeverTestsTwoBodiesThatAreBothFixed) {
  SceneDescription description = test::stacked_cubes(0.1);
  for (BodyDescription& body : description.bodies) {
    for (int v = 0; v < body.mesh.vertices.cols(); ++v) body.pinned.push_back(v);
  }
  EXPECT_FALSE(build_scene(description).pairs_possible);
}

TEST(DetectPairs, KeepsAContactThatHasJustOpenedAndDropsItBeyondTheHysteresis) {
  const double depth = 1e-7;
  SceneDescription description = test::stacked_cubes(depth);
  description.gravity = {{0.0}, {Vec3(0, 0, -10)}};
  const Scene scene = build_scene(description);
  Options options;
  options.time_step = 1e-3;
  ASSERT_GT(scene.swing_time, 20.0 * options.time_step);
  options.pairs.hysteresis = 1e-3 / scene.swing_time;  // gaps below |g|Δt · 1e-3 s = 1e-5 m
  test::Found touching(scene, options, initial_state(scene));
  const std::size_t count = touching.workspace.pairs.size();
  ASSERT_GT(count, 0u);
  State state = touching.state;
  remember_pairs(touching.workspace.pairs, scene.topology, state.pair_geometry);
  const auto lifted = [&](double gap) {
    State up = state;
    const Body& upper = scene.bodies[1];
    for (int v = upper.first_vertex; v < upper.first_vertex + upper.vertex_count; ++v) {
      up.position[static_cast<std::size_t>(v)].x.z() += depth + gap;
    }
    return test::Found(scene, options, up).workspace.pairs;
  };
  const PairContacts kept = lifted(0.9e-5);
  EXPECT_EQ(kept.size(), count);
  for (const PairContact& contact : kept) EXPECT_EQ(contact.depth, 0.0);
  EXPECT_TRUE(lifted(1.1e-5).empty());
}

TEST(DetectPairs, ForgetsAContactThatHasOpenedWhereOnlyTheTieMarginRemembers) {
  const double depth = 1e-7;
  const Scene scene = build_scene(test::stacked_cubes(depth));
  Options options;
  options.pairs.hysteresis = 0.0;
  options.pairs.tie_margin = 1e-3;
  test::Found touching(scene, options, initial_state(scene));
  ASSERT_FALSE(touching.workspace.pairs.empty());
  State state = touching.state;
  remember_pairs(touching.workspace.pairs, scene.topology, state.pair_geometry);
  const Body& upper = scene.bodies[1];
  for (int v = upper.first_vertex; v < upper.first_vertex + upper.vertex_count; ++v) {
    state.position[static_cast<std::size_t>(v)].x.z() += 2.0 * depth;
  }
  Workspace workspace;
  workspace.velocity = state.velocity;
  detect_pairs(scene, options, state, workspace);
  EXPECT_TRUE(workspace.pairs.empty());
}

}  // namespace
}  // namespace stiction
