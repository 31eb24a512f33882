// SPDX-License-Identifier: BSD-3-Clause
#include "solver/mesh/mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <utility>

#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

// Volume enclosed by triangles, by the divergence theorem: positive when they look outwards.
double enclosed_volume(const TetMesh& mesh, const Eigen::Matrix3Xi& triangles) {
  double volume = 0.0;
  for (const auto& t : triangles.colwise()) {
    const Eigen::Vector3d a = mesh.vertices.col(t[0]);
    const Eigen::Vector3d b = mesh.vertices.col(t[1]);
    const Eigen::Vector3d c = mesh.vertices.col(t[2]);
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

// Each directed edge of a closed oriented surface is used once, and once in the other direction.
bool is_closed(const Eigen::Matrix3Xi& triangles) {
  std::map<std::pair<int, int>, int> uses;
  for (const auto& t : triangles.colwise()) {
    for (int k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : uses) {
    const auto back = uses.find({edge.second, edge.first});
    if (count != 1 || back == uses.end()) return false;
  }
  return !uses.empty();
}

TEST(SurfaceTriangles, OfOneTetrahedronAreItsFourFacesLookingOutwards) {
  const TetMesh mesh = test::corner_tetrahedron();
  const Eigen::Matrix3Xi triangles = surface_triangles(mesh.tetrahedra);
  ASSERT_EQ(triangles.cols(), 4);
  EXPECT_TRUE(is_closed(triangles));
  const Eigen::Vector3d centre = mesh.vertices.rowwise().mean();
  for (const auto& t : triangles.colwise()) {
    const Eigen::Vector3d a = mesh.vertices.col(t[0]);
    const Eigen::Vector3d outward = Eigen::Vector3d(mesh.vertices.col(t[1]) - a)
                                        .cross(Eigen::Vector3d(mesh.vertices.col(t[2]) - a));
    EXPECT_GT(outward.dot(a - centre), 0.0) << "triangle " << t.transpose();
  }
}

TEST(SurfaceTriangles, OfACubeDropInnerFacesAndEncloseItsVolume) {
  for (const int n : {1, 2, 3}) {
    const TetMesh mesh = test::cube_mesh(n);
    const Eigen::Matrix3Xi triangles = surface_triangles(mesh.tetrahedra);
    EXPECT_EQ(triangles.cols(), 6 * 2 * n * n) << n << " cells";
    EXPECT_TRUE(is_closed(triangles)) << n << " cells";
    // Round-off: 12 n² triangles, each a product of coordinates ≤ 1.
    EXPECT_NEAR(enclosed_volume(mesh, triangles), 1.0, 12 * n * n * test::kEpsilon);
  }
}

TEST(SurfaceTriangles, StandInTheOrderOfTheirTetrahedra) {
  // Two tetrahedra that share the face (1, 2, 3).
  Eigen::Matrix4Xi tetrahedra(4, 2);
  tetrahedra << 0, 4, 1, 1, 2, 3, 3, 2;
  const Eigen::Matrix3Xi triangles = surface_triangles(tetrahedra);
  ASSERT_EQ(triangles.cols(), 6);
  for (Eigen::Index t = 0; t < 6; ++t) {
    EXPECT_EQ((triangles.col(t).array() == (t < 3 ? 0 : 4)).count(), 1) << "triangle " << t;
  }
}

TEST(SurfaceTriangles, OfNoTetrahedraAreNone) {
  EXPECT_EQ(surface_triangles(Eigen::Matrix4Xi(4, 0)).cols(), 0);
}

TEST(SignedVolume, IsASixthOfTheDeterminantAndTurnsSignWithTwoCorners) {
  TetMesh mesh = test::corner_tetrahedron(3.0);
  EXPECT_DOUBLE_EQ(signed_volume(mesh, 0), 4.5);
  std::swap(mesh.tetrahedra(1, 0), mesh.tetrahedra(2, 0));
  EXPECT_DOUBLE_EQ(signed_volume(mesh, 0), -4.5);
}

}  // namespace
}  // namespace stiction
