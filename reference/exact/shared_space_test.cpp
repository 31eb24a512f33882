// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/shared_space.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "reference/meshes/box_mesh.h"

namespace stiction::reference {
namespace {

using Eigen::Vector3d;

constexpr double kAllowed = 1e-13;

SolidMesh box(const Vector3d& size, const Vector3d& at,
              const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity(), int cells = 1) {
  SolidMesh solid{box_mesh(size, Eigen::Vector3i::Constant(cells)), {}};
  solid.mesh.vertices = (turn * solid.mesh.vertices).colwise() + at;
  return solid;
}

bool share(const Solid& a, const Solid& b) { return shared_space({a, b}, kAllowed).has_value(); }

TEST(SharedSpace, IsSeenOfBodiesThatCoincide) {
  EXPECT_TRUE(share(box({1, 1, 1}, {0, 0, 0}), box({1, 1, 1}, {0, 0, 0})));
  EXPECT_TRUE(
      share(box({1, 1, 1}, {0, 0, 0}), box({1, 1, 1}, {0, 0, 0}, Eigen::Matrix3d::Identity(), 3)));
  EXPECT_TRUE(share(SolidBall{{0, 0, 0}, 1}, SolidBall{{0, 0, 0}, 1}));
}

TEST(SharedSpace, IsSeenWhereNoVertexAndNoEdgeIsInside) {
  // Two beams of one height that cross: each edge lies in a face of the other.
  EXPECT_TRUE(share(box({3, 1, 1}, {0, 0, 0}), box({1, 3, 1}, {0, 0, 0})));
  EXPECT_TRUE(share(box({1, 1, 1}, {0, 0, 0}), box({1, 1, 1}, {0.5, 0, 0}))) << "shifted";
  EXPECT_TRUE(share(box({3, 3, 3}, {0, 0, 0}), box({1, 1, 1}, {0.1, 0, 0}))) << "swallowed";
}

TEST(SharedSpace, IsNoneOfBodiesThatTouchHoweverTheyAreTurned) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 50; ++k) {
    const Eigen::Quaterniond q =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
            .normalized();
    const Eigen::Matrix3d turn = q.toRotationMatrix();
    const auto at = [&](double x, double y, double z) -> Vector3d {
      return turn * Vector3d(x, y, z);
    };
    const SolidMesh below = box({1, 1, 1}, at(0, 0, 0), turn, 2);
    EXPECT_FALSE(share(below, box({1, 1, 1}, at(0, 0, 1), turn, 3))) << k;
    EXPECT_FALSE(share(below, box({1, 1, 1}, at(0.3, 0.2, 1), turn))) << k;
    EXPECT_FALSE(share(below, box({1, 1, 1}, at(1, 1, 1), turn))) << k << ", corner on corner";
    EXPECT_TRUE(share(below, box({1, 1, 1}, at(0.3, 0.2, 1 - 1e-11), turn))) << k;
  }
}

TEST(SharedSpace, OfBallsAndPointsIsOfTheSphere) {
  const SolidMesh cube = box({1, 1, 1}, {0, 0, 0});
  EXPECT_FALSE(share(cube, SolidBall{{0, 0, 1}, 0.5}));
  EXPECT_TRUE(share(cube, SolidBall{{0, 0, 1}, 0.5 + 1e-9}));
  EXPECT_TRUE(share(SolidBall{{0.1, 0, 0}, 0.01}, cube)) << "inside";
  EXPECT_FALSE(share(SolidBall{{0, 0, 0}, 1}, SolidBall{{0, 0, 1.5}, 0.5}));
  EXPECT_TRUE(share(SolidBall{{0, 0, 0}, 1}, SolidBall{{0, 0, 1.5}, 0.6}));
  EXPECT_TRUE(share(cube, SolidPoint{{0.1, 0.2, 0.3}}));
  EXPECT_FALSE(share(cube, SolidPoint{{0.1, 0.2, 0.5}}));
  EXPECT_TRUE(share(SolidPoint{{0.1, 0.2, 0.3}}, SolidBall{{0, 0, 0}, 1}));
  EXPECT_FALSE(share(SolidPoint{{0, 0, 0}}, SolidPoint{{0, 0, 0}}));
}

TEST(SharedSpace, TellsThePairAndHowDeep) {
  const auto found = shared_space({box({1, 1, 1}, {5, 0, 0}), box({1, 1, 1}, {0, 0, 0}),
                                   SolidPoint{{9, 9, 9}}, box({1, 1, 1}, {0, 0, 1 - 2e-3})},
                                  kAllowed);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->first, 1u);
  EXPECT_EQ(found->second, 3u);
  EXPECT_GT(found->depth, 0.9e-3);
  EXPECT_LT(found->depth, 1.01e-3);
}

TEST(SharedSpace, OfHeldPartsIsNone) {
  SolidMesh wall = box({1, 1, 1}, {0, 0, 0}), other = box({1, 1, 1}, {0.5, 0, 0});
  wall.held.assign(8, true);
  EXPECT_TRUE(share(wall, other));
  other.held.assign(8, true);
  EXPECT_FALSE(share(wall, other));
}

}  // namespace
}  // namespace stiction::reference
