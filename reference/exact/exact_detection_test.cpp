// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/exact_detection.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "reference/meshes/ball_mesh.h"
#include "reference/meshes/nonconvex_shapes.h"

namespace stiction::reference {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Corners = Eigen::Matrix<double, 3, 4>;

Corners reference_tetrahedron() {
  Corners x;
  x << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  return x;
}

/// A cube [−1, 1]³ as the jack's middle cell would be cut: five tetrahedra.
TetMesh cube() {
  TetMesh mesh;
  mesh.vertices.resize(3, 8);
  for (int c = 0; c < 8; ++c) {
    mesh.vertices.col(c) << (c & 1 ? 1.0 : -1.0), (c & 2 ? 1.0 : -1.0), (c & 4 ? 1.0 : -1.0);
  }
  mesh.tetrahedra.resize(4, 5);
  mesh.tetrahedra << 0, 1, 2, 4, 7, 3, 0, 3, 5, 6, 5, 3, 0, 6, 5, 6, 5, 6, 0, 3;
  for (Index e = 0; e < 5; ++e) {
    if (signed_volume(mesh, e) < 0.0) std::swap(mesh.tetrahedra(2, e), mesh.tetrahedra(3, e));
  }
  return mesh;
}

TEST(ExactSide, OneUnitInTheLastPlaceDecides) {
  const Corners x = reference_tetrahedron();
  const double quarter = 0.25;
  EXPECT_EQ(side_of_tetrahedron(Vector3d::Constant(0.2), x), Side::inside);
  EXPECT_EQ(side_of_tetrahedron({quarter, quarter, 0.0}, x), Side::boundary);  // a face
  EXPECT_EQ(side_of_tetrahedron({quarter, quarter, 0.5}, x), Side::boundary);  // the slanted one
  EXPECT_EQ(side_of_tetrahedron({0.5, 0.0, 0.0}, x), Side::boundary);          // an edge
  EXPECT_EQ(side_of_tetrahedron({0.0, 1.0, 0.0}, x), Side::boundary);          // a vertex
  EXPECT_EQ(side_of_tetrahedron({quarter, quarter, std::nextafter(0.5, 0.0)}, x), Side::inside);
  EXPECT_EQ(side_of_tetrahedron({quarter, quarter, std::nextafter(0.5, 1.0)}, x), Side::outside);
  EXPECT_EQ(side_of_tetrahedron({quarter, quarter, -std::numeric_limits<double>::denorm_min()}, x),
            Side::outside);
}

TEST(ExactSide, DoesNotDependOnOrientation) {
  Corners x = reference_tetrahedron();
  x.col(0).swap(x.col(1));
  EXPECT_EQ(side_of_tetrahedron(Vector3d::Constant(0.2), x), Side::inside);
  EXPECT_EQ(side_of_tetrahedron(Vector3d::Constant(0.4), x), Side::outside);
}

TEST(ExactSide, WeightsAreTheNearestDoubles) {
  const Corners x = reference_tetrahedron();
  const Eigen::Vector4d w = exact_weights({0.1, 0.2, 0.7}, x);
  EXPECT_EQ(w[1], 0.1);  // here the weights are the coordinates themselves
  EXPECT_EQ(w[2], 0.2);
  EXPECT_EQ(w[3], 0.7);
  // The three doubles add up to 1 − 2⁻⁵⁵, exactly; in doubles nothing would be left.
  EXPECT_EQ(w[0], std::ldexp(1.0, -55));
  EXPECT_EQ(1.0 - (0.1 + 0.2 + 0.7), 0.0);
}

TEST(ExactSide, RefusesFlatAndEndless) {
  Corners x = reference_tetrahedron();
  x.col(3) << 0.3, 0.3, 0.0;
  EXPECT_THROW(side_of_tetrahedron(Vector3d::Zero(), x), std::invalid_argument);
  EXPECT_THROW(exact_weights(Vector3d::Zero(), x), std::invalid_argument);
  x(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(side_of_tetrahedron(Vector3d::Zero(), x), std::invalid_argument);
  TetMesh inverted = cube();
  std::swap(inverted.tetrahedra(0, 0), inverted.tetrahedra(1, 0));
  EXPECT_THROW(ExactBody{inverted}, std::invalid_argument);
}

/// The jack of edge 1 is the union of seven cubes with corners at halves: decided by comparisons.
Side side_of_jack(const Vector3d& p) {
  const Vector3d a = p.cwiseAbs();
  int beyond_half = 0;
  int at_half = 0;
  for (const double x : a) {
    beyond_half += x > 0.5 ? 1 : 0;
    at_half += x == 0.5 ? 1 : 0;
  }
  if (a.maxCoeff() > 1.5 || beyond_half > 1) return Side::outside;
  if (a.maxCoeff() == 1.5) return Side::boundary;
  if (beyond_half == 1) return at_half > 0 ? Side::boundary : Side::inside;
  // In the middle cube: where one coordinate is ½ an arm begins, two make a re-entrant edge.
  return at_half >= 2 ? Side::boundary : Side::inside;
}

TEST(ExactBodySide, JackOnAGridOfDegeneratePoints) {
  const ExactBody jack(shape_mesh(Shape::jack, 1.0));
  int count[3] = {0, 0, 0};
  for (int i = -7; i <= 7; ++i) {
    for (int j = -7; j <= 7; ++j) {
      for (int k = -7; k <= 7; ++k) {
        const Vector3d p = 0.25 * Vector3d(i, j, k);
        const Side expected = side_of_jack(p);
        ASSERT_EQ(jack.side(p), expected) << p.transpose();
        ++count[static_cast<int>(expected)];
      }
    }
  }
  for (const int times : count) EXPECT_GT(times, 100);
}

TEST(ExactBodySide, JackAtRandomPointsOnAndBesideItsSurface) {
  const ExactBody jack(shape_mesh(Shape::jack, 1.0));
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1.6, 1.6);
  for (int trial = 0; trial < 3000; ++trial) {
    Vector3d p(uniform(generator), uniform(generator), uniform(generator));
    if (trial % 3 == 1) p[trial % 2] = std::copysign(0.5, p[trial % 2]);
    if (trial % 3 == 2) p[trial % 2] = std::nextafter(std::copysign(0.5, p[trial % 2]), 9.0);
    ASSERT_EQ(jack.side(p), side_of_jack(p)) << p.transpose();
  }
}

TEST(ExactBodySide, SharedFacesNameAllTheirTetrahedra) {
  const ExactBody body(cube());
  EXPECT_EQ(body.tetrahedra_at({1.0, -1.0, -1.0}).size(), 1);   // a corner tetrahedron's own
  EXPECT_EQ(body.tetrahedra_at({-1.0, -1.0, -1.0}).size(), 4);  // the regular one and three others
  EXPECT_EQ(body.tetrahedra_at(Vector3d::Zero()).size(), 1);
  EXPECT_TRUE(body.tetrahedra_at({2.0, 0.0, 0.0}).empty());
  EXPECT_EQ(body.side({0.0, 0.0, -1.0}), Side::boundary);
  EXPECT_EQ(body.side(Vector3d::Constant(1.0 / 3.0)), Side::inside);  // on an inner face, or nearly
}

TEST(ClosestOnSurface, CubeIsAClamp) {  // analytic
  const ExactBody body(cube());
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> integer(-40, 40);
  for (int trial = 0; trial < 300; ++trial) {
    const Vector3d p = 0.125 * Vector3d(integer(generator), integer(generator), integer(generator));
    if (p.cwiseAbs().maxCoeff() <= 1.0) continue;
    const Vector3d expected = p.cwiseMax(-1.0).cwiseMin(1.0);
    const ClosestPoint closest = body.closest_point(p);
    EXPECT_EQ(closest.squared_distance, (p - expected).squaredNorm());  // small integers over 64
    EXPECT_EQ(closest.point, expected);
    EXPECT_TRUE(closest.unique_point);
  }
}

TEST(ClosestOnSurface, TiesAreCounted) {
  const ExactBody body(cube());
  const ClosestPoint face = body.closest_point({0.5, 0.25, 2.0});
  EXPECT_EQ(face.triangles.size(), 1);
  const ClosestPoint diagonal = body.closest_point({0.0, 0.0, 3.0});
  EXPECT_EQ(diagonal.triangles.size(), 2);  // both halves of the face
  EXPECT_TRUE(diagonal.unique_point);
  const ClosestPoint edge = body.closest_point({2.0, 2.0, 0.0});
  EXPECT_EQ(edge.triangles.size(), 2);
  EXPECT_EQ(edge.squared_distance, 2.0);
  const ClosestPoint corner = body.closest_point({2.0, 2.0, 2.0});
  EXPECT_EQ(corner.triangles.size(), 3);  // vertex 7 has no diagonal
  EXPECT_EQ(corner.squared_distance, 3.0);
  const ClosestPoint middle = body.closest_point(Vector3d::Zero());
  EXPECT_EQ(middle.triangles.size(), 12);  // the foot on each face lies on its diagonal
  EXPECT_FALSE(middle.unique_point);
  EXPECT_EQ(middle.squared_distance, 1.0);
  const ClosestPoint nudged = body.closest_point({0.0, 0.0, 1e-300});
  EXPECT_EQ(nudged.triangles.size(), 2);  // what no double distance can tell
  EXPECT_EQ(nudged.point.z(), 1.0);
  EXPECT_EQ(nudged.squared_distance, 1.0);
}

TEST(ClosestOnSurface, BallAgreesWithASearchInDoubles) {
  const TetMesh mesh = ball_mesh({.frequency = 3});
  const ExactBody ball(mesh);
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-1.3, 1.3);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector3d p(uniform(generator), uniform(generator), uniform(generator));
    const ClosestPoint closest = ball.closest_point(p);
    // The reported point is the weights' point, at the reported distance.
    Vector3d sum = Vector3d::Zero();
    for (Index k = 0; k < 3; ++k) {
      sum += closest.weights[k] * mesh.vertices.col(ball.surface()(k, closest.triangle));
    }
    constexpr double kRounding = 1e-15;  // a few operations on numbers about one
    EXPECT_LT((sum - closest.point).norm(), kRounding);
    EXPECT_NEAR((p - closest.point).squaredNorm(), closest.squared_distance, 4 * kRounding);
    // No sample of any triangle is closer: a brute-force twin.
    double least = std::numeric_limits<double>::infinity();
    for (Index f = 0; f < ball.surface().cols(); ++f) {
      for (int i = 0; i <= 12; ++i) {
        for (int j = 0; i + j <= 12; ++j) {
          const Vector3d q = (i * mesh.vertices.col(ball.surface()(0, f)) +
                              j * mesh.vertices.col(ball.surface()(1, f)) +
                              (12 - i - j) * mesh.vertices.col(ball.surface()(2, f))) /
                             12.0;
          least = std::min(least, (p - q).squaredNorm());
        }
      }
    }
    EXPECT_LE(closest.squared_distance, least + 4 * kRounding);
    // A sample lies within 0.43/12/√3 of any point; distances differ by less.
    EXPECT_GE(std::sqrt(closest.squared_distance), std::sqrt(least) - 0.43 / 12.0 / std::sqrt(3.0));
  }
}

}  // namespace
}  // namespace stiction::reference
