// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/nonconvex_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "reference/exact/exact_detection.h"
#include "reference/meshes/box_mesh.h"

namespace stiction::reference {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

class Shapes : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(All, Shapes, testing::ValuesIn(kShapes),
                         [](const auto& parameter) { return name(parameter.param); });

TEST_P(Shapes, AreSoundAndHaveTheVolumeOfTheirCubes) {
  for (const int cells : {1, 2, 3}) {
    const TetMesh mesh = shape_mesh(GetParam(), 0.02, cells);
    const MeshCertificate certificate = certify(mesh);
    EXPECT_EQ(certificate.non_positive_tetrahedra, 0);
    EXPECT_EQ(certificate.non_manifold_faces, 0);
    EXPECT_EQ(certificate.unused_vertices, 0);
    EXPECT_TRUE(certificate.boundary_closed);
    EXPECT_EQ(certificate.boundary_euler_characteristic, 2);
    // Each coordinate is rounded once, at 1e-16 of the size (3 edges); a face moves by that.
    EXPECT_NEAR(certificate.volume.nearest / shape_volume(GetParam(), 0.02), 1.0, 1e-14);
    EXPECT_NEAR(certificate.quality.min_dihedral_angle,
                std::acos(1.0 / std::sqrt(3.0)) * 180.0 / M_PI, 1e-9);
  }
}

TEST_P(Shapes, RestOnTheirCentreOfMass) {
  const TetMesh mesh = shape_mesh(GetParam(), 1.0);
  Vector3d moment = Vector3d::Zero();
  for (Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    Vector3d middle = Vector3d::Zero();
    for (Index k = 0; k < 4; ++k) middle += 0.25 * mesh.vertices.col(mesh.tetrahedra(k, e));
    moment += signed_volume(mesh, e) * middle;
  }
  EXPECT_LT(moment.norm(), 1e-14);  // sums of some 35 terms below one, 1e-16 each
}

TEST_P(Shapes, AreNotConvex) {
  const TetMesh mesh = shape_mesh(GetParam(), 1.0);
  const ExactBody body(mesh);
  // The middle of two vertices lies outside for at least one pair.
  int outside = 0;
  for (Index a = 0; a < mesh.vertices.cols(); ++a) {
    for (Index b = 0; b < a; ++b) {
      const Vector3d middle = 0.5 * (mesh.vertices.col(a) + mesh.vertices.col(b));
      if (body.side(middle) == Side::outside) ++outside;
    }
  }
  EXPECT_GT(outside, 0);
}

TEST_P(Shapes, AreCoarse) {
  const TetMesh mesh = shape_mesh(GetParam(), 1.0);
  const auto count = static_cast<Index>(cubes(GetParam()).size());
  EXPECT_EQ(mesh.vertices.cols(), 8 + 4 * (count - 1));  // each joint shares four
  EXPECT_EQ(mesh.tetrahedra.cols(), 5 * count);
}

TEST(NonconvexShapes, RefuseWhatMakesNoSense) {
  EXPECT_THROW(shape_mesh(Shape::l, 0.0), std::invalid_argument);
  EXPECT_THROW(shape_mesh(Shape::l, std::numeric_limits<double>::infinity()),
               std::invalid_argument);
  EXPECT_THROW(shape_mesh(Shape::l, 1.0, 0), std::invalid_argument);
}

}  // namespace
}  // namespace stiction::reference
