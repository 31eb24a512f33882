// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/holding.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "solver/lanes/lane_width.h"
#include "solver/lanes/lanes.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

using Corners = std::array<Vec3, 4>;

Real least_weight(const Vec3& point, const Corners& corner) {
  return barycentric(point, corner[0], corner[1], corner[2], corner[3]).minCoeff();
}

// Moves the point by a share of `within` and the corners by the rest, all by 0.999 of it: the point
// across a face and its corners against it, or each anywhere. Calls look(point, corners).
template <class Look>
void move_each_way(const Vec3& point, const Corners& corner, Real within, unsigned seed,
                   const Look& look) {
  for (unsigned k = 0; k < 36; ++k) {
    const Real share = Real(0.5) * static_cast<Real>(k % 3), by = Real(0.999) * within;
    const Eigen::Matrix3Xd any = test::noise(5, 1.0, 50 * seed + k).colwise().normalized();
    Vec3 way[5];
    for (int v = 0; v < 5; ++v) way[v] = any.col(v).cast<Real>();
    if (k < 24) {
      const std::size_t face = k / 3 % 4;
      const Vec3 &a = corner[(face + 1) % 4], &b = corner[(face + 2) % 4],
                 &c = corner[(face + 3) % 4];
      const Vec3 across = (k < 12 ? 1 : -1) * (b - a).cross(c - a).normalized();
      for (int v = 0; v < 4; ++v) way[v] = -across;
      way[4] = across;
    }
    Corners moved = corner;
    for (std::size_t v = 0; v < 4; ++v) moved[v] += (1 - share) * by * way[v];
    look(Vec3(point + share * by * way[4]), moved);
  }
}

// Corners and a point of a tetrahedron, the more often a flat one the higher the seed.
struct Placed {
  Corners corner;
  Vec3 point;

  explicit Placed(unsigned seed) {
    const Eigen::Matrix3Xd random = test::noise(6, 1.0, seed);
    const Real flat = std::pow(Real(10), -static_cast<Real>(seed % 4));
    for (int v = 0; v < 4; ++v) {
      corner[static_cast<std::size_t>(v)] = random.col(v).cast<Real>();
      corner[static_cast<std::size_t>(v)].z() *= flat;
    }
    // Of some the point is just inside or outside.
    const Real out = seed % 3 == 0 ? Real(1e-3) : Real(0.5);
    Vec4 weight =
        (random.col(4).homogeneous().cast<Real>().cwiseAbs() + Vec4::Constant(Real(0.01)));
    weight[seed % 4] *= out * static_cast<Real>(seed % 2 == 0 ? 1 : -1);
    weight /= weight.sum();
    point = Vec3::Zero();
    for (std::size_t v = 0; v < 4; ++v) point += weight[static_cast<Eigen::Index>(v)] * corner[v];
  }
};

TEST(Holding, LeastWeightsSideBySideAreThoseOfOneAtEveryWidth) {
  for (const int width : lane_widths()) {
    for (unsigned seed = 0; seed < 200; ++seed) {
      const Placed placed(seed);
      std::vector<Vec3> x(placed.corner.begin(), placed.corner.end());
      for (unsigned k = 0; x.size() < 12; ++k) x.push_back(Placed(seed + k + 1).point);
      // Tetrahedra that share vertices.
      const int count = 1 + static_cast<int>(seed) % lanes_of(width);
      std::int32_t vertex[kMostLanes][4];
      const std::int32_t* corner[kMostLanes];
      for (int k = 0; k < count; ++k) {
        for (int v = 0; v < 4; ++v) vertex[k][v] = k + v;
        corner[k] = vertex[k];
      }
      Real least[kMostLanes];
      least_weights(placed.point, x, corner, count, width, least);
      for (int k = 0; k < count; ++k) {
        const auto first = x.begin() + k;
        EXPECT_EQ(least[k], least_weight(placed.point, {first[0], first[1], first[2], first[3]}))
            << "seed " << seed << ", " << k << " of " << count << " at width " << width;
      }
      // Of a point each.
      std::int32_t point[kMostLanes];
      for (int k = 0; k < count; ++k) point[k] = (5 * k + static_cast<int>(seed)) % 12;
      least_weights(point, x, corner, count, width, least);
      for (int k = 0; k < count; ++k) {
        const auto first = x.begin() + k;
        EXPECT_EQ(least[k], least_weight(x[static_cast<std::size_t>(point[k])],
                                         {first[0], first[1], first[2], first[3]}))
            << "seed " << seed << ", " << k << " of " << count << " at width " << width;
      }
    }
  }
}

TEST(Holding, LastsWhileNothingMovesAsFarAsItsBound) {
  int held = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    const Placed placed(seed);
    const Real within = held_within(placed.point, placed.corner);
    EXPECT_EQ(within > 0.0, least_weight(placed.point, placed.corner) > 2 * kInside) << seed;
    if (!(within > 0.0)) continue;
    ++held;
    move_each_way(placed.point, placed.corner, within, seed,
                  [&](const Vec3& point, const Corners& corner) {
                    EXPECT_GT(least_weight(point, corner), kInside) << seed;
                  });
  }
  EXPECT_GT(held, 500);
}

TEST(Holding, DoesNotBeginWhileNothingMovesAsFarAsItsBound) {
  int clear = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    const Placed placed(seed);
    const Real within = clearance(placed.point, placed.corner);
    if (!(within > 0.0)) continue;
    ++clear;
    move_each_way(placed.point, placed.corner, within, seed,
                  [&](const Vec3& point, const Corners& corner) {
                    EXPECT_LT(least_weight(point, corner), kOnBoundary) << seed;
                  });
  }
  EXPECT_GT(clear, 500);
}

}  // namespace
}  // namespace stiction
