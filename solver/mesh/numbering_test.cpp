// SPDX-License-Identifier: BSD-3-Clause
#include "solver/mesh/numbering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

// The vertices of a mesh in an order that knows nothing of space.
TetMesh shuffled(const TetMesh& mesh, unsigned seed) {
  std::vector<int> place(static_cast<std::size_t>(mesh.vertices.cols()));
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), std::mt19937(seed));
  TetMesh other = mesh;
  for (Eigen::Index v = 0; v < mesh.vertices.cols(); ++v) {
    other.vertices.col(place[static_cast<std::size_t>(v)]) = mesh.vertices.col(v);
  }
  for (int& v : other.tetrahedra.reshaped()) v = place[static_cast<std::size_t>(v)];
  return other;
}

// The coordinates in the order of the numbering.
Eigen::Matrix3Xd renumbered(const TetMesh& mesh, const Numbering& numbering) {
  Eigen::Matrix3Xd vertices(3, mesh.vertices.cols());
  for (Eigen::Index v = 0; v < mesh.vertices.cols(); ++v) {
    vertices.col(numbering.place[static_cast<std::size_t>(v)]) = mesh.vertices.col(v);
  }
  return vertices;
}

double mean_neighbour_distance(const Eigen::Matrix3Xd& vertices) {
  const Eigen::Index n = vertices.cols() - 1;
  return (vertices.rightCols(n) - vertices.leftCols(n)).colwise().norm().mean();
}

TEST(SpatialNumbering, IsAPermutation) {
  const Numbering numbering = spatial_numbering(shuffled(test::cube_mesh(4), 1));
  std::vector<int> sorted = numbering.place;
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> all(125);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all);
}

TEST(SpatialNumbering, PutsSurfaceVerticesFirst) {
  const TetMesh mesh = shuffled(test::cube_mesh(4), 2);
  const Numbering numbering = spatial_numbering(mesh);
  EXPECT_EQ(numbering.surface_count, 125 - 27);  // 5³ vertices, 3³ of them inside
  for (Eigen::Index v = 0; v < mesh.vertices.cols(); ++v) {
    const Eigen::Array3d x = mesh.vertices.col(v).array();
    const bool on_surface = (x == 0.0 || x == 1.0).any();
    EXPECT_EQ(numbering.place[static_cast<std::size_t>(v)] < numbering.surface_count, on_surface)
        << "vertex at " << x.transpose();
  }
}

TEST(SpatialNumbering, BringsVerticesNearInSpaceNearInMemory) {
  const TetMesh mesh = shuffled(test::cube_mesh(8), 3);
  const Eigen::Matrix3Xd ordered = renumbered(mesh, spatial_numbering(mesh));
  // Random points of a unit cube are 0.66 apart; along a Z-order curve through a lattice of spacing
  // h the mean jump is below 2h, and holes left by the surface/inner split widen it: 0.25 = 2h.
  EXPECT_GT(mean_neighbour_distance(mesh.vertices), 0.6);
  EXPECT_LT(mean_neighbour_distance(ordered), 0.25);
}

TEST(SpatialNumbering, DoesNotDependOnTheDescribedOrder) {
  const TetMesh a = shuffled(test::cube_mesh(3), 4);
  const TetMesh b = shuffled(test::cube_mesh(3), 5);
  ASSERT_FALSE(a.vertices == b.vertices);
  EXPECT_EQ(renumbered(a, spatial_numbering(a)), renumbered(b, spatial_numbering(b)));
}

TEST(SpatialNumbering, CountsVerticesWithoutTetrahedraAsSurface) {
  TetMesh mesh;
  mesh.vertices = Eigen::Matrix3Xd::Zero(3, 3);
  mesh.vertices.row(0) << 2.0, 0.0, 1.0;
  const Numbering numbering = spatial_numbering(mesh);
  EXPECT_EQ(numbering.surface_count, 3);
  EXPECT_EQ(numbering.place, (std::vector<int>{2, 0, 1}));
}

TEST(SpatialNumbering, KeepsTheOrderOfCoincidentPoints) {
  TetMesh mesh;
  mesh.vertices = Eigen::Matrix3Xd::Ones(3, 4);
  EXPECT_EQ(spatial_numbering(mesh).place, (std::vector<int>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace stiction
