// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/depth.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "solver/depth/nearest.h"
#include "solver/depth/remember_pairs.h"
#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

Options with(PairWeights weights, DepthRule depth) {
  Options options;
  options.pairs.weights = weights;
  options.pairs.face = PairFace::kNearest;
  options.pairs.depth = depth;
  return options;
}

// A point on the diagonal between two side faces of a cube, a hair nearer to x = 0.
TEST(TieMargin, KeepsTheTriangleOfTheLastStep) {
  const double depth = 0.1, nearer = 1e-6;
  SceneDescription description;
  description.bodies = {test::elastic_body(test::cube_mesh(3)), {}};
  description.bodies[1].mesh.vertices = Vec3(depth - nearer, depth, 0.45);
  description.bodies[1].point_mass = 1.0;
  const Scene scene = build_scene(description);
  Options options;
  const auto normal_after = [&](const Vec3& last_normal, double margin) {
    options.pairs.tie_margin = margin;
    State state = initial_state(scene);
    // One step before, the point was nearer to the face of `last_normal`.
    state.position.back().x += 1e-3 * last_normal;
    test::Found last(scene, options, state);
    remember_pairs(last.workspace.pairs, scene.topology, state.pair_geometry);
    state.position.back().x -= 1e-3 * last_normal;
    const test::Found now(scene, options, state);
    EXPECT_EQ(now.workspace.pairs.size(), 1u);
    return now.workspace.pairs.front().normal;
  };
  const Vec3 x = -Vec3::UnitX(), y = -Vec3::UnitY();
  EXPECT_LT((normal_after(x, 1e-3) - x).norm(), 1e-12);
  EXPECT_LT((normal_after(y, 1e-3) - y).norm(), 1e-12);
  EXPECT_LT((normal_after(y, 0.0) - x).norm(), 1e-12) << "without margin the nearest one wins";
  EXPECT_LT((normal_after(y, 0.5 * nearer / depth) - x).norm(), 1e-12) << "beyond the margin too";
}

// Pushed to the nearest point of a triangle that it has left for the next one in a flat face, a vertex would be
// pushed aside, and one that sticks there held by more than its friction.
TEST(TieMargin, DoesNotPushAVertexAsideThatHasPassedAnEdgeOfAFlatFace) {
  const double depth = 0.01;
  SceneDescription description;
  description.bodies = {test::elastic_body(test::cube_mesh(1)), {}};
  description.bodies[1].mesh.vertices = Vec3(0.5, 0.5, 1.0 - depth);
  description.bodies[1].point_mass = 1.0;
  const Scene scene = build_scene(description);
  const Options options;
  State state = initial_state(scene);
  // Over the middle of the face, across whichever diagonal its two triangles share.
  for (const double beside : {-0.1, 0.01, 0.05, 0.1}) {
    state.position.back().x.x() = 0.5 + beside * depth;
    test::Found now(scene, options, state);
    ASSERT_EQ(now.workspace.pairs.size(), 1u);
    const PairContact& contact = now.workspace.pairs[0];
    EXPECT_LT((contact.normal - Vec3::UnitZ()).norm(), 1e-14) << beside;
    EXPECT_NEAR(contact.depth, depth, 1e-15) << beside;
    remember_pairs(now.workspace.pairs, scene.topology, state.pair_geometry);
  }
}

// Two cubes of one cell, the upper one exactly on the lower one but for `depth`.
SceneDescription flush_cubes(double depth) {
  SceneDescription description;
  description.bodies = {test::elastic_body(test::cube_mesh(1)),
                        test::elastic_body(test::cube_mesh(1))};
  description.bodies[1].mesh.vertices.row(2).array() += 1.0 - depth;
  return description;
}

TEST(OpposedFace, OfFlushCubesIsTheOneTheyRestOn) {
  const double depth = 1e-4;
  const Scene scene = build_scene(flush_cubes(depth));
  const auto across = [&](PairFace face) {
    Options options;
    options.pairs.face = face;
    const test::Found found(scene, options, initial_state(scene));
    int count = 0;
    EXPECT_EQ(found.workspace.pairs.size(), 8u) << "four corners of each";
    for (const PairContact& contact : found.workspace.pairs) {
      if (std::abs(contact.normal.z()) < 0.5) {
        ++count;
      } else {
        EXPECT_NEAR(contact.depth, depth, 1e-15);
      }
    }
    return count;
  };
  EXPECT_EQ(across(PairFace::kOpposed), 0);
  EXPECT_GT(across(PairFace::kNearest), 0) << "a corner is on a side wall, which is nearer";
}

// Corners on the side walls of the other cube: what stands behind the face below without having
// come there is answered by and by, and what has fallen there at once.
TEST(SideEntry, IsAnsweredByAndBy) {
  const double depth = 5e-3;
  const Scene scene = build_scene(flush_cubes(depth));
  const Options options;
  State state = initial_state(scene);
  state.step = 1;
  double expected = depth - options.pairs.border_margin * scene.topology.mean_edge / 3.0;
  for (int step = 0; step < 3; ++step, expected *= 0.9) {
    test::Found found(scene, options, state);
    ASSERT_EQ(found.workspace.pairs.size(), 8u);
    int by_and_by = 0;
    for (const PairContact& contact : found.workspace.pairs) {
      const Real excess = found.workspace.pairs.site_of(contact).excess;
      EXPECT_NEAR(contact.depth + excess, depth, 1e-15);
      if (excess == 0.0) continue;
      EXPECT_NEAR(excess, expected, 1e-15) << "step " << step;
      ++by_and_by;
    }
    EXPECT_GT(by_and_by, 0) << "step " << step;
    remember_pairs(found.workspace.pairs, scene.topology, state.pair_geometry);
  }

  State falling = initial_state(scene);
  falling.step = 1;
  for (int v = scene.bodies[1].first_vertex; v < scene.vertex_count(); ++v) {
    const auto k = static_cast<std::size_t>(v);
    falling.position[k].x.z() += depth;
    falling.velocity[k].v.z() = -depth / options.time_step;
  }
  const test::Found found(scene, options, falling);
  ASSERT_EQ(found.workspace.pairs.size(), 8u);
  for (const PairContact& contact : found.workspace.pairs) {
    EXPECT_NEAR(found.workspace.pairs.site_of(contact).excess, 0.0, 1e-15);
    EXPECT_NEAR(contact.depth, depth, 1e-15);
  }
}

TEST(BorderMargin, KeepsAVertexAHairBeyondItsFace) {
  Scene scene = build_scene(flush_cubes(1e-4));
  const auto contacts_after = [&](double shift) {
    Options options;
    State state = initial_state(scene);
    test::Found before(scene, options, state);
    remember_pairs(before.workspace.pairs, scene.topology, state.pair_geometry);
    for (int v = scene.bodies[1].first_vertex; v < scene.vertex_count(); ++v) {
      state.position[static_cast<std::size_t>(v)].x += Vec3(shift, shift, 0.0);
    }
    const test::Found after(scene, options, state);
    for (const PairContact& contact : after.workspace.pairs) {
      EXPECT_GT(std::abs(contact.normal.z()), 0.99);
      EXPECT_NEAR(contact.depth, 1e-4, 1e-15);
    }
    return after.workspace.pairs.size();
  };
  const double margin = 1e-3 * scene.topology.mean_edge;
  EXPECT_EQ(contacts_after(0.5 * margin), 8u);
  EXPECT_EQ(contacts_after(2.0 * margin), 2u) << "one corner of each is in the other";
}

TEST(Topology, TheLeastWidthOfAKuhnCubeIsThatBetweenItsSkewEdges) {
  const Scene scene = build_scene(test::stacked_cubes(0.1));
  // Of a cell of edge c the edges (0, 0, 0)–(c, c, 0) and (c, 0, 0)–(c, c, c) are c/√3 apart.
  EXPECT_NEAR(scene.topology.least_width[0], std::sqrt(1.0 / 3.0) / 3.0, 1e-15);
  EXPECT_NEAR(scene.topology.least_width[1], std::sqrt(1.0 / 3.0) / 2.0, 1e-15);
  EXPECT_EQ(scene.topology.thinnest, scene.topology.least_width[0]);
}

// A state that diverges is told of by its engine, some steps later. What is read for a triangle of
// number −1 only a sanitizer sees.
TEST(Depths, AreThoseOfNumbers) {
  const Scene scene = build_scene(test::stacked_cubes(0.01));
  Options options;
  State state = initial_state(scene);
  test::Found last(scene, options, state);
  remember_pairs(last.workspace.pairs, scene.topology, state.pair_geometry);
  for (const double bad : {test::kNaN, test::kInfinity}) {
    const std::int32_t vertex = last.workspace.pairs.front().vertex;
    state.position[static_cast<std::size_t>(vertex)].x = Vec3(0.0, bad, 0.0);
    const test::Found now(scene, options, state);
    EXPECT_GT(now.workspace.pairs.size(), 0u);
    for (const PairContact& contact : now.workspace.pairs) {
      EXPECT_NE(contact.vertex, vertex);
      EXPECT_GE(now.workspace.pairs.site_of(contact).triangle, 0);
    }
  }
}

class FlatContact : public testing::TestWithParam<DepthRule> {};

// Upper vertices inside the lower cube's top, and lower ones inside the upper's bottom: both faces
// are flat, so each rule must find the overlap and the vertical.
TEST_P(FlatContact, HasTheOverlapAsDepthAndTheFaceNormal) {
  const double overlap = 0.01;
  const Scene scene = build_scene(test::stacked_cubes(overlap));
  test::Found found(scene, with(PairWeights::kTriangle, GetParam()), initial_state(scene));
  ASSERT_GT(found.workspace.pairs.size(), 8u);
  int deep = 0;
  for (const PairContact& contact : found.workspace.pairs) {
    // Vertices on a side of the other body, within the overlap of a vertical face, look sideways.
    if (std::abs(contact.normal.z()) < 0.9) continue;
    const bool upper = scene.topology.vertex_body[static_cast<std::size_t>(contact.vertex)] == 1;
    // The consistent rule averages over all edges that leave the other body, those through its side
    // faces included: at ≥ 0.13 from the side they weigh (0.01/0.13)² = 0.6 % of a vertical one,
    // and ask for 13 times its depth.
    const bool averages = GetParam() == DepthRule::kConsistent;
    EXPECT_NEAR(contact.depth, overlap, averages ? 0.08 * overlap : 1e-12);
    EXPECT_NEAR(contact.normal.z(), upper ? 1.0 : -1.0, averages ? 1e-4 : 1e-12);
    ++deep;
  }
  EXPECT_GE(deep, 8);
}

INSTANTIATE_TEST_SUITE_P(Rules, FlatContact,
                         testing::Values(DepthRule::kProjection, DepthRule::kConsistent),
                         [](const auto& one) {
                           return one.param == DepthRule::kProjection ? "Projection" : "Consistent";
                         });

// The triangles near an element hold the nearest one of all.
TEST(Depths, AreTheDistanceToTheWholeSurface) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Scene scene = build_scene(test::stacked_cubes(0.25));
    const State state =
        test::state_at(scene, scene.rest_position + test::noise(scene.vertex_count(), 0.04, seed),
                       Eigen::Matrix3Xd::Zero(3, scene.vertex_count()));
    const test::Found found(scene, with(PairWeights::kTriangle, DepthRule::kProjection), state);
    ASSERT_FALSE(found.workspace.pairs.empty());
    for (const PairContact& contact : found.workspace.pairs) {
      double best = test::kInfinity;
      const auto x = [&](std::int32_t v) -> const Vec3& {
        return state.position[static_cast<std::size_t>(v)].x;
      };
      for (const Topology::Triangle& triangle : scene.topology.triangle) {
        if (scene.topology.vertex_body[static_cast<std::size_t>(triangle.vertex[0])] ==
            scene.topology.vertex_body[static_cast<std::size_t>(contact.vertex)]) {
          continue;
        }
        best = std::min(best, nearest_on_triangle(x(contact.vertex), x(triangle.vertex[0]),
                                                  x(triangle.vertex[1]), x(triangle.vertex[2]))
                                  .distance2);
      }
      EXPECT_NEAR(contact.depth, std::sqrt(best), 1e-14) << "seed " << seed;
    }
  }
}

TEST(Depths, TetrahedralWeightsGiveTheVertexItsPlaceAtTheStartOfTheStep) {
  const Scene scene = build_scene(test::stacked_cubes(0.05));
  const test::Found found(
      scene, with(PairWeights::kTetrahedron, DepthRule::kProjection),
      test::state_at(scene, scene.rest_position, test::noise(scene.vertex_count(), 1.0, 5)));
  for (const PairContact& contact : found.workspace.pairs) {
    Vec3 x = Vec3::Zero();
    double sum = 0.0;
    double inverse_mass = scene.inverse_mass[static_cast<std::size_t>(contact.vertex)];
    for (int k = 0; k < 4; ++k) {
      const auto j = static_cast<std::size_t>(contact.partner[k]);
      x += contact.weight[k] * found.state.position[j].x;
      sum += contact.weight[k];
      inverse_mass += contact.weight[k] * contact.weight[k] * scene.inverse_mass[j];
    }
    // Round-off of a 3 × 3 solve in numbers of order one.
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_LT((x - found.state.position[static_cast<std::size_t>(contact.vertex)].x).norm(), 1e-14);
    EXPECT_NEAR(contact.inverse_mass, inverse_mass, 1e-14 * inverse_mass);
  }
}

// A vertex that is kept above a surface which has folded may be nearest to a face beside itself.
TEST(Depths, FindNoContactOfAVertexWithAnElementThatItIsACornerOf) {
  SceneDescription description = test::stacked_cubes(-1.0);  // apart
  description.gravity = {{0.0}, {Vec3(0, 0, -9.81)}};  // what a kept contact may gape by goes by it
  description.bodies[0].self_collision = true;
  const Scene scene = build_scene(description);
  const Topology::Triangle& beside = scene.topology.triangle[0];
  State start = initial_state(scene);
  start.pair_geometry.body_key = {contact_key(beside.vertex[0], 0)};
  start.pair_geometry.element = {beside.element};
  start.pair_geometry.triangle = {0};
  for (const PairWeights weights : {PairWeights::kTriangle, PairWeights::kTetrahedron}) {
    Options options;
    options.pairs.weights = weights;
    EXPECT_TRUE(test::Found(scene, options, start).workspace.pairs.empty());
  }
}

// What a contact is known by and acts on.
struct Identity {
  ContactKey key;
  std::array<std::int32_t, 4> partner;
  bool operator==(const Identity&) const = default;
};

std::vector<Identity> identities(const PairContacts& pairs) {
  std::vector<Identity> all;
  for (const PairContact& contact : pairs) {
    all.push_back({contact.key(), std::to_array(contact.partner)});
  }
  return all;
}

// A cube slides over another, whose faces and elements it comes to, while vertices come and go.
TEST(Depths, SayThatContactsAreTheSameOnlyWhereTheyAre) {
  SceneDescription description = test::stacked_cubes(1e-3);
  description.gravity = {{0.0}, {Vec3(0, 0, -9.81)}};
  const Scene scene = build_scene(description);
  for (const PairWeights weights : {PairWeights::kTriangle, PairWeights::kTetrahedron}) {
    for (const PairKey key : {PairKey::kBody, PairKey::kTriangle}) {
      Options options;
      options.time_step = 0.1 * scene.stable_time_step;
      options.pairs.weights = weights;
      options.pairs.key = key;
      State state = initial_state(scene);
      Workspace workspace;
      workspace.velocity = state.velocity;
      std::map<std::uint64_t, std::vector<Identity>> seen;
      for (unsigned k = 0; k < 300; ++k) {
        state.position = test::on_its_way(scene, k, Vec3(4e-3, -3e-3, 0), 1e-4).position;
        detect_pairs(scene, options, state, workspace);
        depths(scene, options, state, workspace);
        const PairContacts& pairs = workspace.pairs;
        ASSERT_NE(pairs.same_order, 0U);
        const auto [known, is_new] = seen.emplace(pairs.same_order, identities(pairs));
        EXPECT_TRUE(is_new || known->second == identities(pairs)) << "step " << k;
        remember_pairs(workspace.pairs, scene.topology, state.pair_geometry);
      }
      // Some steps change nothing, and some do.
      EXPECT_GT(seen.size(), 10U);
      if (key == PairKey::kTriangle) continue;  // another number in each step
      EXPECT_LT(seen.size(), 250U);
    }
  }
}

TEST(Depths, TheLiteralKeyNamesTheTriangle) {
  const Scene scene = build_scene(test::stacked_cubes(0.05));
  Options options;
  options.pairs.key = PairKey::kTriangle;
  const test::Found found(scene, options, initial_state(scene));
  for (const PairContact& contact : found.workspace.pairs) {
    const std::int32_t triangle = found.workspace.pairs.site_of(contact).triangle;
    EXPECT_EQ(contact.key(), contact_key(contact.vertex, static_cast<std::uint32_t>(triangle)));
  }
}

}  // namespace
}  // namespace stiction
