// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/box_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace stiction::reference {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

void expect_sound(const MeshCertificate& certificate) {
  EXPECT_EQ(certificate.non_positive_tetrahedra, 0);
  EXPECT_EQ(certificate.non_manifold_faces, 0);
  EXPECT_EQ(certificate.unused_vertices, 0);
  EXPECT_TRUE(certificate.boundary_closed);
}

ExactVolume bounding_box_volume(const TetMesh& mesh) {
  return exact_box_volume(mesh.vertices.rowwise().minCoeff(), mesh.vertices.rowwise().maxCoeff());
}

TetMesh single_tetrahedron() {
  TetMesh mesh{Eigen::Matrix3Xd::Zero(3, 4), Eigen::Matrix4Xi(4, 1)};
  mesh.vertices.rightCols<3>().setIdentity();
  mesh.tetrahedra << 0, 1, 2, 3;
  return mesh;
}

// The mesh without the tetrahedra for which `remove` holds of the centroid.
template <typename Predicate>
TetMesh without(const TetMesh& mesh, Predicate remove) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    const Eigen::Vector3d centroid =
        mesh.vertices(Eigen::all, mesh.tetrahedra.col(e)).rowwise().mean();
    if (!remove(centroid)) kept.push_back(e);
  }
  return {mesh.vertices, mesh.tetrahedra(Eigen::all, kept)};
}

class BoxMesh : public testing::TestWithParam<Eigen::Vector3i> {};

// Expected (exact-computed): the tetrahedra fill the box of the doubles that are there, to the last
// digit, for sizes that binary cannot hold.
TEST_P(BoxMesh, FillsItsBoxExactly) {
  const Eigen::Vector3i cells = GetParam();
  const Eigen::Vector3d size(0.1, 0.7, 1.0 / 3.0);
  const TetMesh mesh = box_mesh(size, cells);
  const MeshCertificate certificate = certify(mesh);
  expect_sound(certificate);
  EXPECT_EQ(mesh.vertices.cols(), (cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1));
  EXPECT_EQ(mesh.tetrahedra.cols(), 5 * cells.prod());
  EXPECT_EQ(certificate.volume.fraction, bounding_box_volume(mesh).fraction);
  EXPECT_EQ(certificate.volume.fraction, exact_box_volume(-size / 2.0, size / 2.0).fraction);
  EXPECT_EQ(certificate.boundary_euler_characteristic, 2);
  EXPECT_EQ(certificate.boundary_triangles,
            4 * (cells[0] * cells[1] + cells[1] * cells[2] + cells[2] * cells[0]));
  EXPECT_EQ(certificate.boundary_triangles, surface_triangles(mesh.tetrahedra).cols());
  // Symmetric about the origin, bit by bit.
  EXPECT_EQ(mesh.vertices, -mesh.vertices.rowwise().reverse());
}

INSTANTIATE_TEST_SUITE_P(Cells, BoxMesh,
                         testing::Values(Eigen::Vector3i(1, 1, 1), Eigen::Vector3i(2, 1, 1),
                                         Eigen::Vector3i(1, 2, 1), Eigen::Vector3i(1, 1, 2),
                                         Eigen::Vector3i(3, 2, 4), Eigen::Vector3i(5, 7, 3)),
                         [](const auto& cells) {
                           return std::to_string(cells.param[0]) + "x" +
                                  std::to_string(cells.param[1]) + "x" +
                                  std::to_string(cells.param[2]);
                         });

// Expected (analytic): the inner tetrahedron of a cube is regular (acos ⅓ = 70.5°, √(3/2)), the
// corner ones have 90° thrice, acos(1/√3) = 54.7° thrice, longest edge √2 and altitude 1/√3: √6.
// Tolerance: ten roundings, of atan2 and of the cross products.
TEST(BoxMeshQuality, OfCubes) {
  const MeshCertificate certificate = certify(box_mesh({1.0, 1.0, 1.0}, {2, 2, 2}));
  EXPECT_NEAR(certificate.quality.min_dihedral_angle, std::acos(1.0 / std::sqrt(3.0)) / kDegree,
              2e-13);
  EXPECT_NEAR(certificate.quality.max_dihedral_angle, 90.0, 2e-13);
  EXPECT_NEAR(certificate.quality.max_aspect_ratio, std::sqrt(6.0), 1e-14);
  TetMesh regular{Eigen::Matrix3Xd(3, 4), single_tetrahedron().tetrahedra};
  regular.vertices << 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1;
  const MeshCertificate of_regular = certify(regular);
  EXPECT_EQ(of_regular.volume.fraction, "1/3");
  EXPECT_NEAR(of_regular.quality.min_dihedral_angle, std::acos(1.0 / 3.0) / kDegree, 2e-13);
  EXPECT_NEAR(of_regular.quality.max_dihedral_angle, std::acos(1.0 / 3.0) / kDegree, 2e-13);
  EXPECT_NEAR(of_regular.quality.max_aspect_ratio, std::sqrt(1.5), 1e-14);
}

TEST(ExactVolume, IsAReducedFractionAndItsNearestDouble) {
  EXPECT_EQ(certify(box_mesh({0.5, 0.25, 3.0}, {3, 2, 4})).volume.fraction,
            bounding_box_volume(box_mesh({0.5, 0.25, 3.0}, {1, 1, 1})).fraction);
  EXPECT_EQ(exact_box_volume({0.0, 0.0, 0.0}, {0.5, 0.25, 3.0}).fraction, "3/8");
  EXPECT_EQ(exact_box_volume({0.0, 0.0, 0.0}, {2.0, 4.0, 8.0}).fraction, "64");
  EXPECT_EQ(certify(single_tetrahedron()).volume.fraction, "1/6");
  EXPECT_EQ(certify(single_tetrahedron()).volume.nearest, 1.0 / 6.0);
  // The processor rounds a product to nearest; truncation would differ in half of these.
  for (double a = 0.1; a < 50.0; a *= 1.7) {
    EXPECT_EQ(exact_box_volume({0.0, 0.0, 0.0}, {a, a + 0.3, 1.0}).nearest, a * (a + 0.3));
  }
}

// One unit in the last place of one vertex is far below the resolution of the volume as a double,
// and must still be seen.
TEST(ExactVolume, SeesOneUnitInTheLastPlace) {
  TetMesh mesh = box_mesh({1.0, 1.0, 1.0}, {4, 4, 4});
  const ExactVolume before = certify(mesh).volume;
  mesh.vertices(0, 0) = std::nextafter(mesh.vertices(0, 0), 0.0);
  const ExactVolume after = certify(mesh).volume;
  EXPECT_EQ(before.fraction, "1");
  EXPECT_EQ(before.nearest, after.nearest);
  EXPECT_NE(before.fraction, after.fraction);
}

TEST(Certify, CountsInvertedAndFlatTetrahedra) {
  TetMesh mesh = box_mesh({1.0, 2.0, 3.0}, {2, 2, 2});
  std::swap(mesh.tetrahedra(0, 7), mesh.tetrahedra(1, 7));
  MeshCertificate certificate = certify(mesh);
  EXPECT_EQ(certificate.non_positive_tetrahedra, 1);
  EXPECT_GT(certificate.non_manifold_faces, 0);  // two neighbours now look the same way
  EXPECT_NE(certificate.volume.fraction, bounding_box_volume(mesh).fraction);

  TetMesh flat = single_tetrahedron();
  flat.vertices << 0.1, 0.3, 0.7, 1.1, 0.1, 0.3, 0.7, 1.1, 0.0, 1.0, 0.0, 0.37;
  certificate = certify(flat);
  EXPECT_EQ(certificate.non_positive_tetrahedra, 1);
  EXPECT_EQ(certificate.volume.fraction, "0");
}

// GMP ends the program where a volume of 1e450 m³ becomes a number. Found by the fuzzer.
TEST(Certify, RefusesAVolumeThatNoNumberHolds) {
  TetMesh vast = single_tetrahedron();
  vast.vertices *= 1e150;
  EXPECT_THROW(static_cast<void>(certify(vast)), std::invalid_argument);
  vast.vertices *= 1e-50;
  EXPECT_EQ(certify(vast).volume.nearest, 1e300 / 6.0);
  EXPECT_THROW(static_cast<void>(exact_box_volume({0, 0, 0}, {1e150, 1e150, 1e150})),
               std::invalid_argument);
}

// Base (0.5 + i u, 0.5 + j u), (12, 12), (24, 24) with u = 2⁻⁵³: six times the volume is 12 (j − i)
// u, of which the naive determinant often gets the sign wrong (its terms are near 270, with ulp 512
// u).
TEST(Certify, DecidesWhereFloatingPointCannot) {
  int naive_mistakes = 0;
  for (int i = 0; i < 16; ++i) {
    for (int j = 0; j < 16; ++j) {
      TetMesh thin = single_tetrahedron();
      thin.vertices << 0.5 + i * 0x1p-53, 12, 24, 0, 0.5 + j * 0x1p-53, 12, 24, 0, 0, 0, 0, 1;
      EXPECT_EQ(certify(thin).non_positive_tetrahedra, j > i ? 0 : 1) << i << ", " << j;
      naive_mistakes += (signed_volume(thin, 0) > 0.0) != (j > i);
    }
  }
  EXPECT_GT(naive_mistakes, 0) << "the test has lost its bite";
}

TEST(Certify, CountsUnusedVertices) {
  TetMesh mesh = single_tetrahedron();
  mesh.vertices.conservativeResize(3, 6);
  mesh.vertices.rightCols<2>().setConstant(5.0);
  EXPECT_EQ(certify(mesh).unused_vertices, 2);
}

// Two cells with the same split: the diagonals of their common face cross, which opens the boundary
// there although the volume is right.
TEST(Certify, SeesDiagonalsThatDoNotMatch) {
  const TetMesh cell = box_mesh({1.0, 1.0, 1.0}, {1, 1, 1});
  TetMesh pair = box_mesh({2.0, 1.0, 1.0}, {2, 1, 1});
  // Vertices of the pair are numbered i + 3 (j + 2 k), of the cell i + 2 (j + 2 k).
  for (Eigen::Index e = 0; e < 5; ++e) {
    for (Eigen::Index c = 0; c < 4; ++c) {
      const int vertex = cell.tetrahedra(c, e);
      pair.tetrahedra(c, e) = vertex % 2 + 3 * (vertex / 2);
      pair.tetrahedra(c, 5 + e) = pair.tetrahedra(c, e) + 1;
    }
  }
  const MeshCertificate certificate = certify(pair);
  EXPECT_EQ(certificate.non_positive_tetrahedra, 0);
  EXPECT_EQ(certificate.volume.fraction, "2");
  EXPECT_FALSE(certificate.boundary_closed);
}

TEST(Certify, KnowsARingFromABall) {
  const TetMesh box = box_mesh({3.0, 3.0, 1.0}, {3, 3, 1});
  const TetMesh ring = without(
      box, [](const Eigen::Vector3d& x) { return x.head<2>().cwiseAbs().maxCoeff() < 0.5; });
  const MeshCertificate certificate = certify(ring);
  expect_sound(certificate);
  EXPECT_EQ(certificate.boundary_euler_characteristic, 0);
  EXPECT_EQ(certificate.volume.fraction, "8");
  // A cavity adds a sphere.
  const TetMesh hollow =
      without(box_mesh({3.0, 3.0, 3.0}, {3, 3, 3}),
              [](const Eigen::Vector3d& x) { return x.cwiseAbs().maxCoeff() < 0.5; });
  EXPECT_EQ(certify(hollow).boundary_euler_characteristic, 4);
  EXPECT_TRUE(certify(hollow).boundary_closed);
}

TEST(Certify, SeesBodiesThatTouchAlongAnEdgeOnly) {
  const TetMesh touching = without(box_mesh({2.0, 2.0, 1.0}, {2, 2, 1}),
                                   [](const Eigen::Vector3d& x) { return x[0] * x[1] < 0.0; });
  EXPECT_FALSE(certify(touching).boundary_closed);
  EXPECT_EQ(certify(touching).non_manifold_faces, 0);
}

TEST(Certify, SeesATetrahedronThatIsThereTwice) {
  TetMesh twice = single_tetrahedron();
  twice.tetrahedra.conservativeResize(4, 2);
  twice.tetrahedra.col(1) = twice.tetrahedra.col(0);
  EXPECT_EQ(certify(twice).non_manifold_faces, 4);
  EXPECT_FALSE(certify(twice).boundary_closed);
}

TEST(BoxMeshErrors, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(box_mesh({1.0, 0.0, 1.0}, {1, 1, 1}), std::invalid_argument);
  EXPECT_THROW(box_mesh({1.0, -1.0, 1.0}, {1, 1, 1}), std::invalid_argument);
  EXPECT_THROW(box_mesh({1.0, 1.0, nan}, {1, 1, 1}), std::invalid_argument);
  EXPECT_THROW(box_mesh({1.0, 1.0, 1.0}, {1, 0, 1}), std::invalid_argument);
  EXPECT_THROW(box_mesh({1.0, 1.0, 1.0}, {2000, 2000, 2000}), std::invalid_argument);
  EXPECT_THROW(exact_box_volume({0.0, 0.0, 0.0}, {1.0, -1.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(exact_box_volume({0.0, 0.0, nan}, {1.0, 1.0, 1.0}), std::invalid_argument);
  TetMesh mesh = single_tetrahedron();
  mesh.vertices(1, 1) = nan;
  EXPECT_THROW(certify(mesh), std::invalid_argument);
  mesh = single_tetrahedron();
  mesh.tetrahedra(2, 0) = 4;
  EXPECT_THROW(certify(mesh), std::invalid_argument);
  EXPECT_THROW(certify({}), std::invalid_argument);
}

}  // namespace
}  // namespace stiction::reference
