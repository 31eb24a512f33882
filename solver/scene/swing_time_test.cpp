// SPDX-License-Identifier: BSD-3-Clause
#include "solver/scene/swing_time.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "solver/scene/body_at_rest.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

double swing_time_of(const BodyDescription& body) { return swing_time(body, lumped_masses(body)); }

// A cube of 1 m, its diagonal √3 m long, of a material in which waves run at 40 m/s.
BodyDescription cube(int cells) {
  return test::elastic_body(test::cube_mesh(cells), {.density = 500.0, .youngs_modulus = 8e5});
}

// Tolerances are a few roundings of coordinates of some metres, of times of some 0.05 s.
TEST(SwingTime, IsTheSizeOverTheSpeedOfWaves) {
  EXPECT_NEAR(swing_time_of(cube(1)), std::sqrt(3.0) / 40.0, 1e-15);
}

TEST(SwingTime, DependsNeitherOnTheMeshNorOnPlaceAndTurn) {
  const double one = swing_time_of(cube(1));
  EXPECT_NEAR(swing_time_of(cube(4)), one, 1e-12 * one);
  BodyDescription turned = cube(2);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  turned.mesh.vertices =
      ((turn * turned.mesh.vertices).colwise() + Eigen::Vector3d(5, -7, 9)).eval();
  EXPECT_NEAR(swing_time_of(turned), one, 1e-12 * one);
}

TEST(SwingTime, OfASceneIsThatOfItsSlowestBodyThatMoves) {
  SceneDescription description = test::one_body(cube(1));
  BodyDescription slow = cube(1);
  slow.material.youngs_modulus = 2e5;
  description.bodies.push_back(slow);
  EXPECT_NEAR(build_scene(description).swing_time, std::sqrt(3.0) / 20.0, 1e-15);
  for (int v = 0; v < slow.mesh.vertices.cols(); ++v) description.bodies[1].pinned.push_back(v);
  EXPECT_NEAR(build_scene(description).swing_time, std::sqrt(3.0) / 40.0, 1e-15);
  const auto points = test::point_masses(Eigen::Matrix3Xd::Zero(3, 1), 2.0);
  EXPECT_EQ(build_scene(test::one_body(points)).swing_time, 0.0);
}

}  // namespace
}  // namespace stiction
