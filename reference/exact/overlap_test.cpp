// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/overlap.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "reference/meshes/ball_mesh.h"
#include "reference/meshes/box_mesh.h"
#include "reference/meshes/nonconvex_shapes.h"

namespace stiction::reference {
namespace {

using Eigen::Vector3d;

Skin skin_of(const TetMesh& mesh, const Vector3d& at = Vector3d::Zero(),
             const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) {
  return {surface_triangles(mesh.tetrahedra), (turn * mesh.vertices).colwise() + at};
}

Skin box(const Vector3d& size, const Vector3d& at, const Eigen::Vector3i& cells = {1, 1, 1}) {
  return skin_of(box_mesh(size, cells), at);
}

TEST(Overlap, OfBoxesApartIsNone) {
  const Skin a = box({1, 1, 1}, {0, 0, 0}), b = box({1, 1, 1}, {1.5, 0.2, 0.1});
  EXPECT_FALSE(deepest(a, b, 0.0));
  EXPECT_FALSE(deepest(b, a, 0.0));
}

TEST(Overlap, OfFlushBoxesIsNoneWhateverTheirRounding) {
  const Skin a = box({0.1, 0.1, 0.1}, {0, 0, 0.05}), b = box({0.1, 0.1, 0.1}, {0, 0, 0.15});
  EXPECT_FALSE(deepest(a, b, 1e-12));
  EXPECT_FALSE(deepest(b, a, 1e-12));
}

TEST(Overlap, DepthOfACornerIsItsDistanceFromTheNearestFace) {
  const Skin a = box({1, 1, 1}, {0, 0, 0}), b = box({1, 1, 1}, {0.9, 0.7, 0.8});
  const auto found = deepest(b, a, 0.01);  // its corner at (0.4, 0.2, 0.3)
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->depth, 0.1, 1e-15);
  EXPECT_FALSE(found->by_an_edge);
  EXPECT_FALSE(deepest(b, a, 0.101)) << "what is allowed is not told";
}

TEST(Overlap, OfCrossedBarsIsByAnEdge) {
  // The upper one has sunk by 0.02: no vertex of one lies in the other.
  const Skin lower = box({1, 0.1, 0.1}, {0, 0, 0}), upper = box({0.1, 1, 0.1}, {0, 0, 0.08});
  const auto found = deepest(upper, lower, 0.01);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->by_an_edge);
  EXPECT_NEAR(found->depth, 0.02, 1e-15);
  EXPECT_NEAR(found->at.z(), 0.03, 1e-15);
}

TEST(Overlap, OfABarThroughASheetIsHalfItsThickness) {
  const Skin sheet = box({1, 1, 0.01}, {0, 0, 0}), bar = box({0.1, 0.1, 1}, {0.1, 0.2, 0.3});
  const auto bar_in_sheet = deepest(bar, sheet, 0.0025);
  ASSERT_TRUE(bar_in_sheet);
  EXPECT_TRUE(bar_in_sheet->by_an_edge);
  EXPECT_NEAR(bar_in_sheet->depth, 0.005, 1e-15);
  EXPECT_TRUE(deepest(bar, sheet, 0.00499)) << "just more than is allowed";
  EXPECT_FALSE(deepest(bar, sheet, 0.00501));
}

TEST(Overlap, OfASwallowedBodyIsOfItsVertices) {
  const Skin big = box({1, 1, 1}, {0, 0, 0}, {2, 2, 2}), small = box({0.2, 0.2, 0.2}, {0, 0, 0});
  const auto found = deepest(small, big, 0.1);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->depth, 0.5, 0.1 + 1e-12);  // at least that of a vertex, 0.4
  EXPECT_FALSE(deepest(big, small, 0.01));
}

// What was known of the surface, and of which vertices it holds, is of the places of then.
TEST(Overlap, IsAskedAnewWhereBodiesHaveMoved) {
  Skin big = box({1, 1, 1}, {0, 0, 0}), small = box({0.2, 0.2, 0.2}, {0, 0, 0});
  const Eigen::Matrix3Xd here = big.vertices(), inside = small.vertices();
  ASSERT_TRUE(deepest(small, big, 0.01));
  big.move(here.colwise() + Vector3d(5, 0, 0));
  EXPECT_FALSE(deepest(small, big, 0.01));
  small.move(inside.colwise() + Vector3d(5.5, 0, 0));
  const auto found = deepest(small, big, 0.01);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->depth, 0.1, 1e-14);
}

// Parts that no edge joins, one inside and one outside, of any order of vertices.
TEST(Overlap, OfOnePartSaysNothingOfAnother) {
  const Skin big = box({1, 1, 1}, {0, 0, 0}, {2, 2, 2}), part = box({0.2, 0.2, 0.2}, {0, 0, 0});
  const Eigen::Index count = part.vertices().cols(), faces = part.triangles().cols();
  Eigen::Matrix3Xi triangles(3, 2 * faces);
  triangles << part.triangles(), part.triangles().array() + static_cast<int>(count);
  for (const bool first_inside : {false, true}) {
    const Vector3d away(0.9, 0.0, 0.0);
    Eigen::Matrix3Xd vertices(3, 2 * count);
    vertices << part.vertices().colwise() + (first_inside ? Vector3d(0, 0, 0) : away),
        part.vertices().colwise() + (first_inside ? away : Vector3d(0, 0, 0));
    const auto found = deepest(Skin(triangles, vertices), big, 0.05);
    ASSERT_TRUE(found) << first_inside;
    EXPECT_NEAR(found->depth, 0.5, 0.1 + 1e-12);
  }
  EXPECT_FALSE(deepest(big, part, 0.11));
}

// By the closed form: centres d apart, of radius r, leave 2r − d; facets take up to their sagitta.
TEST(Overlap, OfBallsIsTheirRadiiLessTheirDistance) {
  const TetMesh ball = ball_mesh({.radius = 1.0, .frequency = 8});
  const auto found = deepest(skin_of(ball, {1.8, 0, 0}), skin_of(ball), 0.01);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->depth, 0.2, 0.02);
}

// A jack's box holds what the jack does not.
TEST(Overlap, OfWhatLiesBetweenTheArmsOfAJackIsNone) {
  const TetMesh jack = shape_mesh(Shape::jack, 1.0, 1);
  const Skin whole = skin_of(jack), between = box({0.2, 0.2, 0.2}, {1.0, 1.0, 1.0});
  EXPECT_FALSE(deepest(between, whole, 0.01));
  EXPECT_TRUE(deepest(box({0.2, 0.2, 0.2}, {0, 0, 0}), whole, 0.01));
}

// Where two arms meet, from whose surfaces no plane parts what lies between them: its edge goes in to the
// corner of both.
TEST(Overlap, OfABoxBetweenTheArmsIsThatOfItsEdge) {
  const TetMesh jack = shape_mesh(Shape::jack, 1.0, 1);
  for (const double deep : {-0.01, 0.01, 0.03, 0.05}) {
    const Skin small = box({0.4, 0.4, 0.4}, {0.7 - deep, 0.7 - deep, 0.1});
    const auto found = deepest(small, skin_of(jack), 0.02);
    EXPECT_EQ(found.has_value(), deep > 0.02) << deep;
    if (found) {
      EXPECT_NEAR(found->depth, std::numbers::sqrt2 * deep, 1e-12);
    }
  }
}

// Just allowed and just not, of boxes that are turned against the axes: what a plane shows is no more than
// what the exact search does.
TEST(Overlap, IsToldFromWhatIsAllowedOnAnySlope) {
  for (int k = 0; k < 20; ++k) {
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.37 * k, Vector3d(1, 2, 3).normalized()) *
                                  Eigen::AngleAxisd(1.1 * k, Vector3d::UnitY()))
                                     .toRotationMatrix();
    const Skin lower = skin_of(box_mesh({1, 1, 1}, {2, 2, 2}), {0, 0, 0}, turn);
    const Skin upper =
        skin_of(box_mesh({0.5, 0.5, 0.5}, {1, 1, 1}), turn * Vector3d(0.1, -0.2, 0.74), turn);
    EXPECT_FALSE(deepest(upper, lower, 0.0101)) << k;
    const auto found = deepest(upper, lower, 0.0099);
    ASSERT_TRUE(found) << k;
    EXPECT_NEAR(found->depth, 0.01, 1e-14) << k;
  }
}

TEST(Overlap, SurvivesEveryTurn) {
  for (int k = 0; k < 50; ++k) {
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.37 * k, Vector3d(1, 2, 3).normalized()) *
                                  Eigen::AngleAxisd(1.1 * k, Vector3d::UnitY()))
                                     .toRotationMatrix();
    const Vector3d aside = turn * Vector3d(0.9, 0.7, 0.8);
    const Skin a = skin_of(box_mesh({1, 1, 1}, {1, 1, 1}), {0, 0, 0}, turn);
    const Skin b = skin_of(box_mesh({1, 1, 1}, {1, 1, 1}), aside, turn);
    const auto found = deepest(b, a, 0.01);
    ASSERT_TRUE(found) << k;
    EXPECT_NEAR(found->depth, 0.1, 1e-14) << k;
  }
}

TEST(Thickness, OfBoxesAndSheetsIsTheirLeastEdge) {
  EXPECT_NEAR(box({1, 1, 1}, {0, 0, 0}, {2, 2, 2}).thickness(), 1.0, 1e-12);
  EXPECT_NEAR(box({1, 2, 0.01}, {3, 0, 0}, {4, 4, 1}).thickness(), 0.01, 1e-12);
  EXPECT_NEAR(box({4, 0.5, 0.5}, {0, 0, 0}, {3, 1, 1}).thickness(), 0.5, 1e-12);
}

TEST(Thickness, OfABallIsAboutItsDiameter) {
  EXPECT_NEAR(skin_of(ball_mesh({.radius = 1.0, .frequency = 6})).thickness(), 2.0, 0.1);
}

TEST(Thickness, OfAJackIsThatOfItsArms) {
  EXPECT_NEAR(skin_of(shape_mesh(Shape::jack, 0.05, 1)).thickness(), 0.05, 1e-12);
}

}  // namespace
}  // namespace stiction::reference
