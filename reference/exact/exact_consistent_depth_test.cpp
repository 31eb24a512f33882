// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/exact_consistent_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "reference/meshes/box_mesh.h"

namespace stiction::reference {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr double kSoftening = 1e-12;
constexpr double kRounding = 1e-15;  // of a result that is exact but for its last rounding

/// A tetrahedron with corner 0 at `tip` and the others at tip + the columns.
TetMesh spike(const Vector3d& tip, const Eigen::Matrix3d& edges) {
  TetMesh mesh;
  mesh.vertices.resize(3, 4);
  mesh.vertices.col(0) = tip;
  for (Index k = 0; k < 3; ++k) mesh.vertices.col(k + 1) = tip + edges.col(k);
  mesh.tetrahedra = Eigen::Vector4i(0, 1, 2, 3);
  if (signed_volume(mesh, 0) < 0.0) std::swap(mesh.tetrahedra(2, 0), mesh.tetrahedra(3, 0));
  return mesh;
}

/// The box [−1, 1]² × [−2, 0].
TetMesh block() {
  TetMesh mesh = box_mesh(Vector3d(2, 2, 2), {2, 2, 2});
  mesh.vertices.colwise() += Vector3d(0, 0, -1) - 0.5 * (mesh.vertices.rowwise().minCoeff() +
                                                         mesh.vertices.rowwise().maxCoeff());
  return mesh;
}

Eigen::Matrix3d upwards() {
  Eigen::Matrix3d edges;
  edges << 0, 1, 0, 0, 0, 1, 4, 4, 4;
  return edges;
}

TEST(ExactConsistentDepth, UnderAPlaneIsTheDepth) {  // analytic: every crossing says the same
  for (const double depth : {0.0, 1e-300, 1e-9, 0.125}) {
    const auto found =
        exact_consistent_depths(spike({0.25, 0.125, -depth}, upwards()), block(), kSoftening);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].vertex, 0);
    EXPECT_EQ(found[0].level, 1);
    EXPECT_NEAR(found[0].depth, depth, kRounding * depth);
    EXPECT_LT((found[0].normal - Vector3d::UnitZ()).norm(), kRounding);
    EXPECT_NEAR(found[0].agreement, 1.0, kRounding);
  }
  EXPECT_TRUE(exact_consistent_depths(
                  spike({0.25, 0.125, std::numeric_limits<double>::denorm_min()}, upwards()),
                  block(), kSoftening)
                  .empty());
}

// Two edges leave through the top, one through a side: the means by hand.
TEST(ExactConsistentDepth, IsTheWeightedMean) {
  Eigen::Matrix3d edges;
  edges << 0, 0, 2, 0, 1, 0, 1, 1, 0;
  const auto found = exact_consistent_depths(spike({0.5, 0.25, -0.25}, edges), block(), 1e-30);
  ASSERT_EQ(found.size(), 1u);
  // Crossings at a quarter of each edge: (0, 0, ¼), (0, ¼, ¼), (½, 0, 0).
  const double w[] = {16.0, 8.0, 4.0};
  EXPECT_NEAR(found[0].depth, (w[0] * 0.25 + w[1] * 0.25 + w[2] * 0.5) / 28.0, kRounding);
  const Vector3d sum(w[2], 0.0, w[0] + w[1]);
  EXPECT_LT((found[0].normal - sum.normalized()).norm(), kRounding);
  EXPECT_NEAR(found[0].agreement, sum.norm() / 28.0, kRounding);
}

TEST(ExactConsistentDepth, ACornerIsCrossedOnceAndLooksBetweenItsFaces) {
  Eigen::Matrix3d edges;
  edges << 1, 1, 0.75, 1, 0.75, 1, 1, 1, 1;
  // From (½, ½, −½) the first edge leaves through the corner (1, 1, 0), the others through edges.
  const auto found = exact_consistent_depths(spike({0.5, 0.5, -0.5}, edges), block(), 1e-30);
  ASSERT_EQ(found.size(), 1u);
  const double s = std::sqrt(0.5), c = std::sqrt(1.0 / 3.0);
  const double w_corner = 1.0 / 0.75, w_edge = 1.0 / (0.25 * (1.0 + 1.0 + 0.5625));
  const double d_corner = 1.5 * c, d_edge = s;
  EXPECT_NEAR(found[0].depth, (w_corner * d_corner + 2 * w_edge * d_edge) / (w_corner + 2 * w_edge),
              kRounding);
  const Vector3d sum =
      w_corner * c * Vector3d(1, 1, 1) + w_edge * s * (Vector3d(1, 0, 1) + Vector3d(0, 1, 1));
  EXPECT_LT((found[0].normal - sum.normalized()).norm(), kRounding);
}

// A box deep in another that is wider: the top alone is crossed, and each layer is a level.
TEST(ExactConsistentDepth, SpreadsInwards) {
  TetMesh column = box_mesh(Vector3d(0.5, 0.5, 1.0), {1, 1, 4});
  column.vertices.row(2).array() += -0.625 - column.vertices.row(2).minCoeff();
  const auto found = exact_consistent_depths(column, block(), kSoftening);
  ASSERT_GE(found.size(), 12u);
  for (const ConsistentDepth& one : found) {
    const double z = column.vertices(2, one.vertex);
    EXPECT_EQ(one.level, static_cast<int>(std::lround(3.0 - (0.625 + z) / 0.25)));
    EXPECT_NEAR(one.depth, -z, kRounding);
    EXPECT_LT((one.normal - Vector3d::UnitZ()).norm(), kRounding);
  }
}

TEST(ExactConsistentDepth, OfABodyWhollyInsideThereIsNone) {
  const auto found =
      exact_consistent_depths(spike({0.1, 0.2, -1.0}, 0.125 * upwards()), block(), kSoftening);
  ASSERT_EQ(found.size(), 4u);
  for (const ConsistentDepth& one : found) EXPECT_EQ(one.level, 0);
}

// p in the middle between top and bottom of a plate, with as much leaving upwards as downwards.
TEST(ExactConsistentDepth, WhereNormalsCancelThereIsNoDirection) {
  TetMesh plate = block();
  plate.vertices.row(2) *= 0.0625;  // from −⅛ to 0
  TetMesh mesh;
  mesh.vertices.resize(3, 4);
  mesh.vertices << 0.25, 0.5, 0.5, 0.25, 0.25, 0.25, 0.25, 5.25, -0.0625, 1, -1.125, -0.0625;
  mesh.tetrahedra = Eigen::Vector4i(0, 1, 2, 3);
  if (signed_volume(mesh, 0) < 0.0) std::swap(mesh.tetrahedra(2, 0), mesh.tetrahedra(3, 0));
  const auto found = exact_consistent_depths(mesh, plate, kSoftening);
  ASSERT_EQ(found.size(), 1u);
  // What is left is the edge that leaves through the side: up and down cancel to the last bit.
  EXPECT_EQ(found[0].level, 1);
  EXPECT_LT((found[0].normal - Vector3d::UnitY()).norm(), kRounding);
  EXPECT_LT(found[0].agreement, 0.01);
}

// What moving the vertex makes of the answer, by differences, stays within the bounds.
TEST(ExactConsistentDepth, BoundsHowFarItMoves) {
  Eigen::Matrix3d edges;
  edges << 0, 0.3, 2, 0.2, 1, 0, 1, 1, 0.1;
  const Vector3d tip(0.5, 0.25, -0.25);
  const auto here = exact_consistent_depths(spike(tip, edges), block(), kSoftening);
  ASSERT_EQ(here.size(), 1u);
  constexpr double kStep = 1e-6;
  double depth = 0.0, turn = 0.0;
  for (const Vector3d& way : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)}) {
    const auto there =
        exact_consistent_depths(spike(tip + kStep * way, edges), block(), kSoftening);
    depth = std::max(depth, std::abs(there.at(0).depth - here[0].depth) / kStep);
    turn = std::max(turn, (there.at(0).normal - here[0].normal).norm() / kStep);
  }
  EXPECT_LT(depth, here[0].moved);
  EXPECT_LT(turn, here[0].turned);
  // Within an order of magnitude: a bound of anything would pass the above.
  EXPECT_GT(10.0 * depth, here[0].moved);
  EXPECT_GT(10.0 * turn, here[0].turned);
}

TEST(ExactConsistentDepth, RefusesWhatIsNoLength) {
  const TetMesh tip = spike({0, 0, -0.5}, upwards());
  EXPECT_THROW(exact_consistent_depths(tip, block(), 0.0), std::invalid_argument);
  EXPECT_THROW(exact_consistent_depths(tip, block(), std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace stiction::reference
