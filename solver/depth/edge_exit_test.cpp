// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/edge_exit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "solver/detection/detect_pairs.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

constexpr double kThin = 1e-12;
constexpr double kLengthRounding =
    100 * test::kEpsilon;  // some thirty roundings of lengths about 1

TetMesh cube_or_notched(bool notched) {
  return notched ? test::notched_cube() : test::cube_mesh(3);
}

/// A scene of one such body and a body far away, so that two could touch.
struct Walked {
  Scene scene;
  std::vector<Vec3> x;
  MeshLinks links;
  WalkScratch scratch;

  explicit Walked(TetMesh mesh) {
    SceneDescription description;
    description.bodies = {test::elastic_body(std::move(mesh)),
                          test::elastic_body(test::cube_mesh(1))};
    description.bodies[0].point_mass = 1.0;  // of vertices that the notch left alone
    description.bodies[1].mesh.vertices.array() += 10.0;
    scene = build_scene(description);
    for (const Position& at : initial_state(scene).position) x.push_back(at.x);
    build_links(scene, links);
    scratch.begin(scene.elements.size(), scene.topology.triangle.size());
  }
  std::int32_t element_at(const Vec3& p) const {
    for (std::size_t e = 0; e < scene.elements.size(); ++e) {
      const auto& v = scene.elements[e].vertex;
      const auto at = [&](int k) { return x[static_cast<std::size_t>(v[k])]; };
      if (barycentric(p, at(0), at(1), at(2), at(3)).minCoeff() > -1e-12) {
        return static_cast<std::int32_t>(e);
      }
    }
    return -1;
  }
  bool find(const Vec3& p, const Vec3& q, Exit& exit) {
    return find_exit(scene, links, x, p, q, element_at(p), kThin, scratch, exit);
  }
};

TEST(MeshLinks, EveryFaceLeadsThereAndBack) {
  const Walked body(cube_or_notched(true));
  std::size_t surface = 0;
  for (std::size_t e = 0; e < body.scene.elements.size(); ++e) {
    for (const std::int32_t behind : body.links.behind[e]) {
      if (behind < 0) {
        const auto& triangle = body.scene.topology.triangle[static_cast<std::size_t>(-1 - behind)];
        EXPECT_EQ(triangle.element, static_cast<std::int32_t>(e));
        ++surface;
        continue;
      }
      const auto& back = body.links.behind[static_cast<std::size_t>(behind)];
      EXPECT_EQ(std::count(back.begin(), back.end(), static_cast<std::int32_t>(e)), 1);
    }
  }
  EXPECT_EQ(surface, body.scene.topology.triangle.size());
}

TEST(ElementAt, IsWhereAWalkFromAnotherElementComesTo) {
  Walked body(cube_or_notched(true));
  const auto vertex = static_cast<std::int32_t>(body.x.size());
  body.x.emplace_back();
  const auto found_from = [&](int element, const Vec3& p) {
    body.x.back() = p;
    return element_at({body.scene, body.links, body.x, vertex, element, kThin}, body.scratch);
  };
  const auto count = static_cast<int>(body.scene.bodies[0].element_count);
  int left = 0;
  for (const Vec3& p : {Vec3(0.21, 0.4, 0.13), Vec3(0.27, 0.61, 0.8), Vec3(0.9, 0.05, 0.72)}) {
    const int own = body.element_at(p);
    const auto& behind = body.links.behind[static_cast<std::size_t>(own)];
    for (int element = 0; element < count; ++element) {
      const int found = found_from(element, p);
      EXPECT_TRUE(found == own || found == element) << element;
      left += found != own;
      if (std::count(behind.begin(), behind.end(), element) > 0) {
        EXPECT_EQ(found, own) << element;
      }
    }
  }
  EXPECT_GT(left, 0);  // across the notch
}

TEST(MeshLinks, NeighboursAreTheEndsOfAllEdges) {
  const Walked body(test::cube_mesh(2));
  // Of Kuhn's cubes the inner vertex has 14 edges, and an edge leads both ways.
  std::size_t most = 0;
  for (std::size_t v = 0; v < body.x.size(); ++v) {
    const auto begin = body.links.neighbour_begin[v], end = body.links.neighbour_begin[v + 1];
    most = std::max(most, static_cast<std::size_t>(end - begin));
  }
  EXPECT_EQ(most, 14u);
  EXPECT_EQ(body.links.neighbour.size() % 2, 0u);
  EXPECT_NEAR(body.links.longest_edge[0], std::sqrt(0.75), kLengthRounding);
}

struct Way {
  const char* name;
  Vec3 p, q;
  double t;     // < 0: it doesn't leave
  Vec3 normal;  // not normalised
};

class Leaving : public testing::TestWithParam<Way> {};

TEST_P(Leaving, IsWhereItFirstLeavesThroughAllThatItTouchesThere) {
  const Way& way = GetParam();
  Walked cube(cube_or_notched(false));
  Exit exit;
  const bool leaves = cube.find(way.p, way.q, exit);
  EXPECT_EQ(leaves, way.t >= 0.0);
  if (!leaves || way.t < 0.0) return;
  EXPECT_NEAR(exit.t, way.t, kLengthRounding);
  EXPECT_LT((exit.normal - way.normal.normalized()).norm(), kLengthRounding);
}

constexpr double kThird = 1.0 / 3.0;

INSTANTIATE_TEST_SUITE_P(
    Cube, Leaving,
    testing::Values(
        Way{"AFace", {0.4, 0.45, 0.5}, {0.5, 0.6, 1.5}, 0.5, {0, 0, 1}},
        Way{"TheDiagonalOfAFace", {0.5, 0.5, 0.5}, {0.5, 0.5, 1.5}, 0.5, {0, 0, 1}},
        Way{"ACornerOfFlatTriangles", {kThird, kThird, 0.5}, {kThird, kThird, 1.5}, 0.5, {0, 0, 1}},
        Way{"AnEdge", {0.5, 0.75, 0.75}, {0.5, 1.25, 1.25}, 0.5, {0, 1, 1}},
        Way{"ACorner", {0.75, 0.75, 0.75}, {1.25, 1.25, 1.25}, 0.5, {1, 1, 1}},
        Way{"ACornerAlongTheDiagonal", {0.25, 0.25, 0.25}, {1.25, 1.25, 1.25}, 0.75, {1, 1, 1}},
        Way{"ACornerWithoutEdgesOfOne", {0.25, 0.75, 0.75}, {-0.25, 1.25, 1.25}, 0.5, {-1, 1, 1}},
        Way{"TheEndOfTheEdgeThatItRunsAlong", {1, 1, 0.5}, {1, 1, 1.5}, 0.5, {0, 0, 1}},
        Way{"TheEndOfTheFaceThatItRunsIn", {0.5, 0.5, 1}, {1.5, 0.5, 1}, 0.5, {1, 0, 0}},
        Way{"NothingInAFace", {0.5, 0.5, 1}, {0.75, 0.6, 1}, -1, {0, 0, 0}},
        Way{"NothingInside", {0.2, 0.3, 0.4}, {0.7, 0.8, 0.9}, -1, {0, 0, 0}},
        Way{"NothingUpToAFace", {0.2, 0.3, 0.4}, {0.7, 0.8, 1.0}, -1, {0, 0, 0}},
        Way{"NothingUpToACorner", {0.2, 0.3, 0.4}, {1.0, 1.0, 1.0}, -1, {0, 0, 0}},
        Way{"TheSurfaceAtOnce", {0.4, 0.45, 1}, {0.5, 0.6, 1.5}, 0.0, {0, 0, 1}},
        Way{"TheSurfaceAtOnceFromJustOutside",
            {0.4, 0.45, 1 + 1e-13},
            {0.5, 0.6, 1.5},
            0.0,
            {0, 0, 1}},
        Way{"ACornerAtOnce", {1, 1, 1}, {1.5, 1.5, 1.5}, 0.0, {1, 1, 1}},
        Way{"TheOtherSideFromTheSurface", {0.4, 0.45, 0}, {0.5, 0.6, 2}, 0.5, {0, 0, 1}}),
    [](const auto& one) { return one.param.name; });

TEST(Leaving, IsOnceHoweverRoundingMovesTheEnds) {
  for (const auto& way : {Way{"", {1, 1, 0.5}, {1, 1, 1.5}, 0.5, {0, 0, 1}},
                          Way{"", {0.5, 0.75, 0.75}, {0.5, 1.25, 1.25}, 0.5, {0, 1, 1}},
                          Way{"", {0.75, 0.75, 0.75}, {1.25, 1.25, 1.25}, 0.5, {1, 1, 1}}}) {
    Walked cube(cube_or_notched(false));
    for (unsigned seed = 0; seed < 200; ++seed) {
      const Eigen::Matrix3Xd by = test::noise(2, 4e-16, seed);
      Exit exit;
      ASSERT_TRUE(cube.find(way.p - 2e-16 * Vec3(1, 1, 0) + by.col(0), way.q + by.col(1), exit));
      EXPECT_NEAR(exit.t, way.t, 1e-14);
      EXPECT_LT((exit.normal - way.normal.normalized()).norm(), 1e-14);
    }
  }
}

TEST(Leaving, IsWhereTheBodyEndsThoughTheEdgeComesBack) {
  Walked notched(cube_or_notched(true));
  Exit exit;
  ASSERT_TRUE(notched.find({0.2, 0.5, 0.8}, {0.9, 0.5, 0.8}, exit));
  EXPECT_NEAR(exit.t, (kThird - 0.2) / 0.7, kLengthRounding);
  EXPECT_LT((exit.normal - Vec3::UnitX()).norm(), kLengthRounding);
}

// The same, of all triangles of the body: the smallest t of those that the segment passes outwards.
bool search_all(const Walked& body, const Vec3& p, const Vec3& q, Exit& exit) {
  exit.t = 2.0;
  for (const Topology::Triangle& triangle : body.scene.topology.triangle) {
    const auto at = [&](int k) { return body.x[static_cast<std::size_t>(triangle.vertex[k])]; };
    const Vec3 a = at(0), normal = (at(1) - a).cross(at(2) - a);
    if (!(normal.dot(q - p) > 0.0)) continue;
    const double t = normal.dot(a - p) / normal.dot(q - p);
    if (t < 0.0 || t > 1.0 || t >= exit.t) continue;
    Mat3 corners;
    corners << at(0), at(1), at(2);
    if ((corners.inverse() * (p + t * (q - p))).minCoeff() < 0.0) continue;
    exit = {t, normal.normalized()};
  }
  return exit.t <= 1.0;
}

TEST(Leaving, IsWhatASearchOfAllTrianglesFinds) {
  int left = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    TetMesh mesh = cube_or_notched(seed % 2 == 1);
    mesh.vertices += test::noise(mesh.vertices.cols(), 0.05, seed);
    Walked body(std::move(mesh));
    for (unsigned k = 0; k < 100; ++k) {
      const Eigen::Matrix3Xd ends = test::noise(2, 0.5, 1000 * (seed + 1) + k);
      const Vec3 p = Vec3::Constant(0.5) + ends.col(0);
      const Vec3 q = Vec3::Constant(0.5) + 3.0 * ends.col(1);
      if (body.element_at(p) < 0) continue;
      Exit expected, exit;
      const bool leaves = search_all(body, p, q, expected);
      ASSERT_EQ(body.find(p, q, exit), leaves);
      if (!leaves) continue;
      // A slope of a hundredth against a face divides the rounding by that.
      EXPECT_NEAR(exit.t, expected.t, 100 * kLengthRounding);
      EXPECT_LT((exit.normal - expected.normal).norm(), kLengthRounding);
      ++left;
    }
  }
  EXPECT_GT(left, 1000);
}

TEST(Leaving, OfWhatIsNoNumberThereIsNone) {
  Walked cube(cube_or_notched(false));
  Exit exit;
  const std::int32_t element = cube.element_at({0.5, 0.5, 0.5});
  for (const double bad : {test::kNaN, test::kInfinity}) {
    EXPECT_FALSE(find_exit(cube.scene, cube.links, cube.x, {bad, 0.5, 0.5}, {0.5, 0.5, 1.5},
                           element, kThin, cube.scratch, exit));
    EXPECT_FALSE(find_exit(cube.scene, cube.links, cube.x, {0.5, 0.5, 0.5}, {0.5, bad, 1.5},
                           element, kThin, cube.scratch, exit));
  }
}

}  // namespace
}  // namespace stiction
