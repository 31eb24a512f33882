// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/spatial_hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

template <int Bytes>
std::vector<int> found_with(SpatialHash& hash, const Box3& box) {
  std::vector<int> sorted;
  for (const std::uint32_t place : hash.places_in<Bytes>(box)) {
    EXPECT_TRUE(box.contains(vector_cast<Vec3>(hash.at(place))));
    sorted.push_back(hash.number(place));
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

std::vector<int> found(SpatialHash& hash, const Vec3& low, const Vec3& high) {
  const Box3 box(low, high);
  const std::vector<int> points = found_with<16>(hash, box);
  EXPECT_EQ(found_with<32>(hash, box), points);
  EXPECT_EQ(found_with<64>(hash, box), points);
  return points;
}

// Points at x = −30 … 30, `apart` of a metre from each other; cells of half a metre.
SpatialHash row_of_points(double apart = 1.0) {
  SpatialHash hash;
  hash.clear(0.5);
  for (int k = -30; k <= 30; ++k) hash.add(k + 30, Vec3(apart * k, 0.1, -0.1));
  hash.build();
  return hash;
}

TEST(SpatialHash, FindsEachPointOfABoxOnce) {
  for (const double apart : {1.0, 100.0}) {  // in rows of cells; hashed
    SpatialHash hash = row_of_points(apart);
    const double x = apart;
    EXPECT_EQ(found(hash, {-x, 0.0, -0.2}, {x, 0.2, 0.0}), (std::vector{29, 30, 31}));
    EXPECT_EQ(found(hash, {x - 0.01, 0.0, -0.2}, {x, 0.2, 0.0}), std::vector<int>{31});
    EXPECT_EQ(found(hash, {0.5 * x, 0.0, -0.2}, {0.5 * x + 0.1, 0.2, 0.0}), std::vector<int>{});
    EXPECT_EQ(found(hash, {-x, 0.11, -0.2}, {x, 0.2, 0.0}), std::vector<int>{})
        << "in its cell alone";
    EXPECT_EQ(found(hash, {31.0 * x, 0.0, -0.2}, {90.0 * x, 0.2, 0.0}), std::vector<int>{});
    EXPECT_EQ(found(hash, {-90.0 * x, 0.0, -0.2}, {-31.0 * x, 0.2, 0.0}), std::vector<int>{});
  }
}

// Clouds of many densities, from 1 cell a point to 1e6, and boxes that reach beyond them, near the origin and
// far away; of so few points that they have no cells, and of more.
TEST(SpatialHash, FindsWhatComparingWithEachFinds) {
  SpatialHash hash;
  const auto cloud = [&](double cell, int count, double away) {
    const Eigen::Matrix3Xd points = test::noise(count, 1.0, 7).array() + away;
    hash.clear(cell);
    Box3 all;
    for (int k = 0; k < count; ++k) {
      hash.add(k, points.col(k));
      all.extend(Vec3(points.col(k)));
    }
    const Box3 around = hash.build();
    EXPECT_EQ(around.min(), all.min());
    EXPECT_EQ(around.max(), all.max());
    for (unsigned seed = 0; seed < 50; ++seed) {
      const Eigen::Matrix3Xd ends = test::noise(2, 1.2, 100 + seed).array() + away;
      const Vec3 low = ends.col(0).cwiseMin(ends.col(1)), high = ends.col(0).cwiseMax(ends.col(1));
      std::vector<int> expected;
      for (int k = 0; k < count; ++k) {
        if (Box3(low, high).contains(Vec3(points.col(k)))) expected.push_back(k);
      }
      EXPECT_EQ(found(hash, low, high), expected)
          << count << " points, cell " << cell << ", seed " << seed << ", " << away << " m away";
    }
  };
  for (const double away : {0.0, -1e6}) {
    for (const double cell : {1.0, 0.3, 0.1, 0.01, 0.003}) {
      for (const int count : {200, 0, 1, 24, 25}) cloud(cell, count, away);
    }
  }
}

TEST(SpatialHash, WalksThePointsWhereThereAreFarMoreCells) {
  SpatialHash hash = row_of_points(100.0);
  EXPECT_EQ(found(hash, Vec3::Constant(-1e5), {-2790, 1e5, 1e5}), (std::vector{0, 1, 2}));
}

TEST(SpatialHash, PlacesWhatHasNoCellOutermost) {
  SpatialHash hash = row_of_points();
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(hash.cell({1e300, infinity, -infinity}), SpatialHash::Cell(1e9, 1e9, -1e9));
  EXPECT_EQ(hash.cell({nan, 0.0, 0.0})[0], static_cast<int>(-1e9));
  EXPECT_EQ(found(hash, Vec3::Constant(-infinity), Vec3::Constant(infinity)).size(), 61u);
}

}  // namespace
}  // namespace stiction
