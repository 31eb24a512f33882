// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/ball_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

namespace stiction::reference {
namespace {

using Eigen::Index;

class Ball : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Frequency, Ball, testing::Values(1, 2, 3, 4, 8),
                         [](const auto& parameter) { return std::to_string(parameter.param); });

TEST_P(Ball, CountsAreTheIcosahedrons) {  // analytic
  const int n = GetParam();
  const BallReport report = examine_ball(ball_mesh({.frequency = n}), 1.0);
  EXPECT_EQ(report.surface_vertices, 10 * n * n + 2);
  EXPECT_EQ(report.facets, 20 * n * n);
  EXPECT_EQ(report.tetrahedra, 20 * n * n * n);
}

TEST_P(Ball, SurfaceVerticesLieOnTheSphere) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  const double radius = 0.0123;
  const BallReport report = examine_ball(
      ball_mesh({.radius = radius, .frequency = GetParam(), .rotation = turn}), radius);
  // Normalisation, product and norm: three half-units in the last place each of radius.
  EXPECT_LE(report.max_radius_error, 4.0 * 1.2e-16 * radius);
}

TEST_P(Ball, TetrahedraAreWellShaped) {
  const BallReport report = examine_ball(ball_mesh({.frequency = GetParam()}), 1.0);
  // Measured 0.76, 0.66, 0.62, 0.60, 0.58 (0.56 at 16); a regular tetrahedron has 0.82.
  EXPECT_GE(report.quality.min_altitude, 0.55 * report.mean_facet_edge);
  EXPECT_LE(report.max_facet_edge, 1.18 * report.min_facet_edge);
  EXPECT_GE(report.quality.min_dihedral_angle, 35.0);
  EXPECT_LE(report.quality.max_dihedral_angle, 120.0);
}

TEST(BallMesh, FrequencyOneIsTheIcosahedron) {  // analytic, edge a = 1/sin(2π/5)
  const BallReport report = examine_ball(ball_mesh({.frequency = 1}), 1.0);
  const double edge = 1.0 / std::sin(2.0 * std::numbers::pi / 5.0);
  const double inradius = edge * std::pow(0.5 * (1.0 + std::sqrt(5.0)), 2) / (2.0 * std::sqrt(3.0));
  constexpr double kRounding = 1e-15;  // of vertices and of a few operations on them
  EXPECT_NEAR(report.volume, 5.0 / 12.0 * (3.0 + std::sqrt(5.0)) * std::pow(edge, 3),
              4 * kRounding);
  EXPECT_NEAR(report.hausdorff_distance, 1.0 - inradius, kRounding);
  EXPECT_NEAR(report.min_facet_edge, edge, kRounding);
  EXPECT_NEAR(report.max_facet_edge, edge, kRounding);
  EXPECT_NEAR(report.max_facet_inradius, edge / (2.0 * std::sqrt(3.0)), kRounding);
}

TEST(BallMesh, ConvergesToTheSphereAtSecondOrder) {
  const BallReport coarse = examine_ball(ball_mesh({.frequency = 4}), 1.0);
  const BallReport fine = examine_ball(ball_mesh({.frequency = 8}), 1.0);
  // Errors a h² + b h⁴ with h halved: ratio 4 (1 + O(h²)), h = 0.3.
  EXPECT_NEAR((1.0 - coarse.volume_ratio) / (1.0 - fine.volume_ratio), 4.0, 0.1);
  EXPECT_NEAR(coarse.hausdorff_distance / fine.hausdorff_distance, 4.0, 0.2);
  // Sagitta of a facet of circumradius ρ = e/√3: 1 − √(1 − ρ²); the largest facet decides.
  EXPECT_NEAR(fine.hausdorff_distance,
              1.0 - std::sqrt(1.0 - std::pow(fine.max_facet_edge, 2) / 3.0), 2e-4);
}

TEST(BallMesh, StandsOnAVertexOrOnAFacet) {
  const TetMesh upright = ball_mesh({.frequency = 4});
  EXPECT_NEAR(upright.vertices.row(2).minCoeff(), -1.0, 1e-15);
  for (const int n : {1, 4, 6, 8}) {
    const TetMesh flat = ball_mesh({.frequency = n, .rotation = facet_down(n)});
    const double lowest = flat.vertices.row(2).minCoeff();
    int corners = 0;
    double next = 1.0;
    for (Index v = 0; v < flat.vertices.cols(); ++v) {
      const double above = flat.vertices(2, v) - lowest;
      if (above < 1e-14) {
        ++corners;
      } else {
        next = std::min(next, above);
      }
    }
    EXPECT_EQ(corners, 3) << "frequency " << n;
    EXPECT_GT(next, 1e-3) << "frequency " << n;
  }
}

TEST(BallMesh, TheSameBitsAgainAndSurfaceVerticesLast) {
  const TetMesh one = ball_mesh({.frequency = 5});
  const TetMesh two = ball_mesh({.frequency = 5});
  EXPECT_TRUE(one.vertices == two.vertices && one.tetrahedra == two.tetrahedra);
  const Index surface = 10 * 25 + 2;
  const Eigen::Matrix3Xi triangles = surface_triangles(one.tetrahedra);
  EXPECT_EQ(triangles.minCoeff(), one.vertices.cols() - surface);
}

TEST(BallMesh, RefusesWhatIsNoBall) {
  EXPECT_THROW(ball_mesh({.radius = -1.0}), std::invalid_argument);
  EXPECT_THROW(ball_mesh({.frequency = 0}), std::invalid_argument);
  EXPECT_THROW(ball_mesh({.rotation = 2.0 * Eigen::Matrix3d::Identity()}), std::invalid_argument);
  TetMesh broken = ball_mesh({.frequency = 2});
  std::swap(broken.tetrahedra(0, 3), broken.tetrahedra(1, 3));
  EXPECT_THROW(examine_ball(broken, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace stiction::reference
