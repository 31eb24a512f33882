// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesh_quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace stiction::reference {
namespace {

// Half a dozen roundings: of 1.1e-16 of numbers between 1 and 2.4 for lengths and their ratios; of
// 2.2e-16 of angles up to π for angles, which are 1.3e-15 rad or 8e-14°.
constexpr double kLengthRoundOff = 2e-15;  // m, dimensionless
constexpr double kAngleRoundOff = 1e-13;   // degrees

TetMesh tetrahedron(const Eigen::Matrix<double, 3, 4>& corners) {
  return {corners, Eigen::Vector4i(0, 1, 2, 3)};
}

TEST(MeshQuality, OfTheRegularTetrahedronIsKnown) {
  Eigen::Matrix<double, 3, 4> corners;  // of edge 2√2
  corners << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
  const MeshQuality quality = mesh_quality(tetrahedron(corners));
  const double degree = std::numbers::pi / 180.0;
  EXPECT_NEAR(quality.min_dihedral_angle, std::acos(1.0 / 3.0) / degree, kAngleRoundOff);
  EXPECT_NEAR(quality.max_dihedral_angle, std::acos(1.0 / 3.0) / degree, kAngleRoundOff);
  EXPECT_NEAR(quality.min_altitude, 4.0 / std::sqrt(3.0), kLengthRoundOff);
  EXPECT_NEAR(quality.max_aspect_ratio, std::sqrt(1.5), kLengthRoundOff);
}

TEST(MeshQuality, OfAFlatTetrahedronSaysSo) {
  Eigen::Matrix<double, 3, 4> corners;
  corners << 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0;
  const MeshQuality quality = mesh_quality(tetrahedron(corners));
  EXPECT_EQ(quality.min_dihedral_angle, 0.0);
  EXPECT_NEAR(quality.max_dihedral_angle, 180.0, kAngleRoundOff);
  EXPECT_EQ(quality.min_altitude, 0.0);
  EXPECT_TRUE(std::isinf(quality.max_aspect_ratio));
}

TEST(MeshQuality, RefusesWhatItCannotRead) {
  EXPECT_THROW(mesh_quality({}), std::invalid_argument);
  TetMesh mesh;
  mesh.vertices = Eigen::Matrix3Xd::Zero(3, 3);
  mesh.tetrahedra = Eigen::Vector4i(0, 1, 2, 3);
  EXPECT_THROW(mesh_quality(mesh), std::invalid_argument);
}

}  // namespace
}  // namespace stiction::reference
