// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/consistent_depth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cfenv>
#include <cmath>

#include "solver/depth/remember_pairs.h"
#include "solver/detection/lasting.h"
#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

// Round-off of a mean of some twenty crossings, each of some thirty roundings of lengths about 1.
constexpr double kRounding = 600 * test::kEpsilon;

struct Depths : test::Found {
  Depths(const Scene& scene, const State& start) : Found(scene, options(), start) {}
  static Options options() {
    Options options;
    options.pairs.depth = DepthRule::kConsistent;
    options.pairs.hysteresis = 0.0;
    return options;
  }
};

SceneDescription two_bodies(TetMesh lower, TetMesh upper, const Vec3& shift) {
  SceneDescription description;
  description.bodies = {test::elastic_body(std::move(lower)), test::elastic_body(std::move(upper))};
  description.bodies[0].name = "lower";
  description.bodies[1].name = "upper";
  description.bodies[1].mesh.vertices.colwise() += shift;
  return description;
}

// The upper body's contacts: vertices of body 1 in body 0.
std::vector<PairContact> upper_contacts(const Scene& scene, const PairContacts& pairs) {
  std::vector<PairContact> upper;
  for (const PairContact& c : pairs) {
    if (scene.topology.vertex_body[static_cast<std::size_t>(c.vertex)] == 1) upper.push_back(c);
  }
  return upper;
}

std::vector<PairContact> upper_depths(const SceneDescription& description) {
  const Scene scene = build_scene(description);
  return upper_contacts(scene, Depths(scene, initial_state(scene)).workspace.pairs);
}

/// A cube on another that it overhangs, its lowest vertices `above` the face; the scene is turned,
/// so that rounding alone says on which side of the face a vertex at 0 lies.
class OnTheSurface : public testing::TestWithParam<double> {};

TEST_P(OnTheSurface, ThereIsNoDepthAndTheDirectionIsTheFaces) {
  const double above = GetParam();
  int seen = 0;
  for (int turn = 0; turn < 8; ++turn) {
    SceneDescription description =
        two_bodies(test::cube_mesh(4), test::cube_mesh(2), Vec3(0.375, 0.21, 1.0 + above));
    const Mat3 rotation =
        Eigen::AngleAxisd(0.7 * turn, Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
    for (BodyDescription& body : description.bodies) {
      body.mesh.vertices = rotation * body.mesh.vertices;
    }
    for (const PairContact& c : upper_depths(description)) {
      // Other edges leave through a side, at a distance of a tenth or more: by their weight they
      // turn the direction.
      const double sides = 100.0 * above * above;
      EXPECT_NEAR(c.depth, std::max(0.0, -above), kRounding + 2.0 * sides);
      EXPECT_LT((c.normal - rotation.col(2)).norm(), kRounding + 4.0 * sides);
      ++seen;
    }
  }
  EXPECT_GE(seen, above > 0.0 ? 1 : 16);
}

INSTANTIATE_TEST_SUITE_P(
    Heights, OnTheSurface,
    testing::Values(0.0, 2e-16, 1e-15, 1e-13, -1e-15, -1e-12, -1e-9, -1e-6, -1e-3),
    [](const auto& one) {
      if (one.param == 0.0) return std::string("Exactly");
      const int power = static_cast<int>(std::lround(-std::log10(std::abs(one.param))));
      return (one.param > 0.0 ? "Outside1em" : "Inside1em") + std::to_string(power);
    });

// Boxes flush with each other: their side faces in one plane, rim on rim and corner on corner.
class Flush : public testing::TestWithParam<double> {};

TEST_P(Flush, BoxesOnBoxesFeelTheOverlapAndTheVertical) {
  const double overlap = GetParam();
  int seen = 0;
  for (int turn = 0; turn < 8; ++turn) {
    SceneDescription description =
        two_bodies(test::cube_mesh(2), test::cube_mesh(2), Vec3(0.0, 0.0, 1.0 - overlap));
    const Mat3 rotation =
        Eigen::AngleAxisd(0.7 * turn, Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
    for (BodyDescription& body : description.bodies) {
      body.mesh.vertices = rotation * body.mesh.vertices;
    }
    const Scene scene = build_scene(description);
    for (const PairContact& c : Depths(scene, initial_state(scene)).workspace.pairs) {
      const bool upper = scene.topology.vertex_body[static_cast<std::size_t>(c.vertex)] == 1;
      EXPECT_NEAR(c.depth, overlap, kRounding);
      EXPECT_LT((c.normal - (upper ? 1.0 : -1.0) * rotation.col(2)).norm(), kRounding);
      ++seen;
    }
    if (turn == 0) {
      EXPECT_EQ(seen, 18);  // later rounding leaves rims outside
    }
  }
  EXPECT_GE(seen, 40);
}

INSTANTIATE_TEST_SUITE_P(Overlaps, Flush, testing::Values(0.0625, 1e-3, 1e-6, 1e-9),
                         [](const auto& one) {
                           return "Em" + std::to_string(std::lround(-std::log10(one.param)));
                         });

// Corner on the vertical edge of the other: it only touches that.
TEST(ConsistentDepth, OfACornerAtAnEdgeIsNoneAndLooksBetweenItsFaces) {
  const auto contacts =
      upper_depths(two_bodies(test::cube_mesh(2), test::cube_mesh(2), Vec3(1.0, 1.0, 0.9375)));
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].depth, 0.0, kRounding);
  EXPECT_LT((contacts[0].normal - Vec3(1, 1, 0).normalized()).norm(), kRounding);
}

// A column deep in a block, of which only the block's top is crossed: each level adds a layer.
TEST(ConsistentDepth, SpreadsInwardsLevelByLevel) {
  SceneDescription description =
      two_bodies(test::cube_mesh(3, 3.0), test::cube_mesh(8), Vec3(1.0, 1.0, 2.4375));
  const Scene scene = build_scene(description);
  const Depths found(scene, initial_state(scene));
  std::vector<int> count(8, 0);
  for (std::size_t c = 0; c < found.workspace.pairs.size(); ++c) {
    const PairContact& contact = found.workspace.pairs[c];
    if (scene.topology.vertex_body[static_cast<std::size_t>(contact.vertex)] == 0) continue;
    const double z = scene.rest_position(2, contact.vertex);
    const int layer = static_cast<int>(std::lround(8.0 * (z - 2.4375)));
    // Depths reach the lowest layer from its rim, as those in the column's middle are no contacts.
    if (layer > 0) {
      EXPECT_EQ(found.workspace.consistent.level[c], 5 - layer);
    } else {
      EXPECT_GE(found.workspace.consistent.level[c], 5);
    }
    EXPECT_NEAR(contact.depth, 3.0 - z, kRounding);
    EXPECT_LT((contact.normal - Vec3::UnitZ()).norm(), kRounding);
    ++count[static_cast<std::size_t>(layer)];
  }
  EXPECT_EQ(count, (std::vector<int>{81, 32, 32, 32, 32, 0, 0, 0}));
}

TEST(ConsistentDepth, OfABodyThatIsWhollyInsideIsTheProjection) {
  const Scene scene =
      build_scene(two_bodies(test::cube_mesh(3), test::cube_mesh(1, 0.1), Vec3(0.4, 0.45, 0.8)));
  const Depths found(scene, initial_state(scene));
  const test::Found projected(scene, Options{}, initial_state(scene));
  ASSERT_EQ(found.workspace.pairs.size(), 8u);
  for (std::size_t c = 0; c < 8; ++c) {
    EXPECT_EQ(found.workspace.consistent.level[c], 0);
    EXPECT_EQ(found.workspace.pairs[c].depth, projected.workspace.pairs[c].depth);
    EXPECT_EQ(found.workspace.pairs[c].normal, projected.workspace.pairs[c].normal);
  }
}

// A pyramid's tip in a plate: its edges leave upwards, and one of a second pyramid downwards.
TEST(ConsistentDepth, InAThinPlateWeighsBothItsSides) {
  TetMesh plate = test::cube_mesh(2);
  plate.vertices.row(2) *= 0.0625;
  TetMesh spindle;  // two tetrahedra that share a face with the corner p = (0.5, 0.5, 0.046875)
  spindle.vertices.resize(3, 5);
  spindle.vertices.col(0) = Vec3(0.5, 0.5, 0.046875);
  spindle.vertices.col(1) = Vec3(0.5, 0.5, 1.046875);
  spindle.vertices.col(2) = Vec3(0.5, 0.75, 0.546875);
  spindle.vertices.col(3) = Vec3(0.75, 0.5, 0.546875);
  spindle.vertices.col(4) = Vec3(0.625, 0.625, -0.953125);
  spindle.tetrahedra.resize(4, 2);
  spindle.tetrahedra << 0, 0, 3, 2, 2, 3, 1, 4;
  const auto contacts = upper_depths(two_bodies(plate, spindle, Vec3::Zero()));
  ASSERT_EQ(contacts.size(), 1u);
  // Up: 1/64 high, three ways of lengths s·|edge|; down: 3/64 of height.
  double weights = 0.0, depth = 0.0, normal = 0.0;
  for (Eigen::Index k = 1; k < 5; ++k) {
    const Vec3 edge = spindle.vertices.col(k) - spindle.vertices.col(0);
    const double high = edge.z() > 0.0 ? 0.015625 : 0.046875;
    const double w = 1.0 / (edge * high / edge.z()).squaredNorm();
    weights += w;
    depth += w * high;
    normal += edge.z() > 0.0 ? w : -w;
  }
  EXPECT_NEAR(contacts[0].depth, depth / weights, kRounding);
  EXPECT_LT((contacts[0].normal - std::copysign(1.0, normal) * Vec3::UnitZ()).norm(), kRounding);
}

Options consistent_options(const Scene& scene) {
  Options options = Depths::options();
  options.time_step = 0.1 * scene.stable_time_step;
  options.pairs.tie_margin = 0.0;
  return options;
}

void expect_same_contacts(const PairContacts& one, const PairContacts& other) {
  EXPECT_TRUE(std::equal(one.begin(), one.end(), other.begin(), other.end(),
                         [&](const PairContact& a, const PairContact& b) {
                           return test::numbers_of(one, a) == test::numbers_of(other, b);
                         }));
}

// In how many contacts of the last step all outlets were known.
std::size_t known_outlets(const Scene& scene, const Workspace& workspace) {
  const PairSearch& search = workspace.search;
  std::size_t known = 0;
  for (const PairContact& contact : workspace.pairs) {
    const Outlets& outlets = search.outlets[static_cast<std::size_t>(contact.vertex)];
    known += outlets.element == workspace.pairs.site_of(contact).element &&
             paths(scene.topology, search, contact.key()) < outlets.until;
  }
  return known;
}

// The last body goes its way over others and all tremble. Each step is measured by what is known of outlets, and
// without.
std::size_t expect_what_walks_find(const SceneDescription& description, const Vec3& each_step,
                                   double tremble, double tie_margin = 0.0) {
  const Scene scene = build_scene(description);
  Options options = consistent_options(scene);
  options.pairs.tie_margin = static_cast<Real>(tie_margin);
  State state = initial_state(scene);
  Workspace kept;
  kept.velocity = state.velocity;
  std::size_t known = 0;
  for (unsigned k = 0; k < 300 && !testing::Test::HasFailure(); ++k) {
    SCOPED_TRACE(k);
    state.position = test::on_its_way(scene, k, each_step, tremble).position;
    detect_pairs(scene, options, state, kept);
    Workspace forgotten = kept;
    forgotten.search.outlets.clear();
    depths(scene, options, state, kept);
    depths(scene, options, state, forgotten);
    expect_same_contacts(kept.pairs, forgotten.pairs);
    known += known_outlets(scene, kept);
    remember_pairs(kept.pairs, scene.topology, state.pair_geometry);
  }
  return known;
}

// With a margin that keeps vertices in elements and without. Gives how many were kept in one that they
// had left.
std::size_t expect_the_same_where_a_margin_keeps(double depth, const Vec3& shift,
                                                 const Vec3& each_step) {
  const Scene scene = build_scene(test::stacked_cubes(depth, shift));
  Options options[] = {consistent_options(scene), consistent_options(scene)};
  options[0].pairs.tie_margin = Real(1e-3);
  State state[] = {initial_state(scene), initial_state(scene)};
  Workspace workspace[2];
  std::size_t kept = 0;
  for (unsigned k = 0; k < 300 && !testing::Test::HasFailure(); ++k) {
    SCOPED_TRACE(k);
    for (int of = 0; of < 2; ++of) {
      workspace[of].velocity = state[of].velocity;
      state[of].position = test::on_its_way(scene, k, each_step, 0.0).position;
      detect_pairs(scene, options[of], state[of], workspace[of]);
      depths(scene, options[of], state[of], workspace[of]);
      remember_pairs(workspace[of].pairs, scene.topology, state[of].pair_geometry);
    }
    const PairContacts &with = workspace[0].pairs, &without = workspace[1].pairs;
    EXPECT_EQ(with.size(), without.size());
    if (with.size() != without.size()) break;
    for (std::size_t c = 0; c < with.size(); ++c) {
      EXPECT_EQ(with[c].vertex, without[c].vertex);
      EXPECT_NEAR(with[c].depth, without[c].depth, kRounding);
      EXPECT_LT((with[c].normal - without[c].normal).norm(), kRounding);
      kept += with.site(c).element != without.site(c).element;
    }
  }
  return kept;
}

TEST(ConsistentDepth, IsTheSameWhateverIsKnownOfOutlets) {
  std::feclearexcept(FE_ALL_EXCEPT);
  std::size_t known = 0;
  for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(0.21, 0.13, 0), Vec3(-0.004, 0.003, 0)}) {
    for (const Vec3& way :
         {Vec3(0, 0, 0), Vec3(1e-6, 0, 0), Vec3(2e-5, 1e-5, 0), Vec3(-3e-4, 1e-4, 1e-6)}) {
      for (const double tremble : {0.0, 1e-9, 1e-6}) {
        known += expect_what_walks_find(test::stacked_cubes(1e-3, shift), way, tremble);
        known += expect_what_walks_find(test::stacked_cubes(1e-6, shift), Real(1e-3) * way,
                                        1e-3 * tremble);
      }
    }
  }
  EXPECT_EQ(std::fetestexcept(FE_DIVBYZERO | FE_INVALID), 0);
  EXPECT_GT(known, 50000u);
}

TEST(ConsistentDepth, IsTheSameWhateverIsKnownOfOutletsOfANotch) {
  std::size_t known = 0;
  for (const double depth : {1e-3, 0.2, 0.7}) {
    SceneDescription description =
        two_bodies(test::notched_cube(), test::cube_mesh(2), Vec3(0.21, 0.13, Real(1 - depth)));
    description.bodies[0].point_mass = 1.0;  // of vertices that the notch left alone
    for (const Vec3& way : {Vec3(1e-6, 0, 0), Vec3(-3e-4, 1e-4, 1e-6)}) {
      known += expect_what_walks_find(description, way, 1e-9);
    }
  }
  EXPECT_GT(known, 10000u);
}

TEST(ConsistentDepth, IsTheSameWhateverIsKnownOfVerticesThatGoFromBodyToBody) {
  SceneDescription description = two_bodies(test::cube_mesh(3), test::cube_mesh(3), Vec3(1, 0, 0));
  description.bodies.push_back(test::elastic_body(test::cube_mesh(2)));
  description.bodies[2].name = "upper";
  description.bodies[2].mesh.vertices.colwise() += Vec3(0.45, 0.13, 0.999);
  std::size_t known = 0;
  for (const double way : {1e-5, 4e-4, -4e-4}) {
    known += expect_what_walks_find(description, Vec3(Real(way), 0, 0), 1e-9);
  }
  EXPECT_GT(known, 1000u);
}

// A vertex over a joint of elements is kept in the one that it has left.
TEST(ConsistentDepth, IsTheSameForVerticesThatAMarginKeeps) {
  for (const double beyond : {1e-6, 3e-5, 1e-4}) {
    // Over a joint at x = ⅓, which it passes in the first of these steps, and stays.
    const Vec3 shift(Real(1) / 3 - Real(0.5 * beyond), 0.1, 0);
    const Vec3 each_step(Real(0.01 * beyond), 0, 0);
    expect_what_walks_find(test::stacked_cubes(1e-3, shift), each_step, 0.0, 1e-3);
    EXPECT_GT(expect_the_same_where_a_margin_keeps(1e-3, shift, each_step), 100u);
  }
}

// Paths begin anew with a scene: what was known in one doesn't hold after another.
TEST(ConsistentDepth, KnowsNothingOfASceneAfterAnother) {
  const Scene scenes[] = {build_scene(test::stacked_cubes(1e-3)),
                          build_scene(test::stacked_cubes(1e-3, Vec3(0.35, 0.4, 0)))};
  Workspace kept;
  const auto measure = [](const Scene& scene, int steps, double by, Workspace& workspace) {
    State state = initial_state(scene);
    for (Position& at : state.position) at.x.x() += static_cast<Real>(by) * at.x.z();
    workspace.velocity = state.velocity;
    for (int k = 0; k < steps; ++k) {
      detect_pairs(scene, consistent_options(scene), state, workspace);
      depths(scene, consistent_options(scene), state, workspace);
    }
  };
  for (const double by : {0.0, 0.1, 0.2}) {
    for (const Scene& scene : scenes) {
      measure(scene, 8, by, kept);
      Workspace fresh;
      measure(scene, 1, by, fresh);
      expect_same_contacts(kept.pairs, fresh.pairs);
      EXPECT_GT(known_outlets(scene, kept), 0u);
    }
  }
}

}  // namespace
}  // namespace stiction
