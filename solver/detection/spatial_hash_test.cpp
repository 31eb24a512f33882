// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/spatial_hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace stiction {
namespace {

using Eigen::Vector3d;

std::vector<int> found(const SpatialHash& hash, const Vector3d& low, const Vector3d& high) {
  std::vector<int> points;
  hash.for_each_in(hash.cell(low), hash.cell(high), [&](int point) { points.push_back(point); });
  std::sort(points.begin(), points.end());
  return points;
}

SpatialHash row_of_points() {
  SpatialHash hash;
  hash.clear(0.5);
  for (int k = -3; k <= 3; ++k) hash.add(k + 3, Vector3d(k, 0.1, -0.1));
  hash.build();
  return hash;
}

TEST(SpatialHash, FindsEachPointOfTheCellsOnce) {
  const SpatialHash hash = row_of_points();
  EXPECT_EQ(found(hash, {-1.0, 0.0, -0.2}, {1.0, 0.2, 0.0}), (std::vector{2, 3, 4}));
  EXPECT_EQ(found(hash, {0.5, 0.0, -0.2}, {0.6, 0.2, 0.0}), std::vector<int>{});
}

TEST(SpatialHash, WalksThePointsWhereThereAreFarMoreCells) {
  const SpatialHash hash = row_of_points();
  EXPECT_EQ(found(hash, Vector3d::Constant(-1e5), {-0.9, 1e5, 1e5}), (std::vector{0, 1, 2}));
}

TEST(SpatialHash, PlacesWhatHasNoCellOutermost) {
  SpatialHash hash = row_of_points();
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(hash.cell({1e300, infinity, -infinity}), SpatialHash::Cell(1e9, 1e9, -1e9));
  EXPECT_EQ(hash.cell({nan, 0.0, 0.0})[0], static_cast<int>(-1e9));
  EXPECT_EQ(found(hash, Vector3d::Constant(-infinity), Vector3d::Constant(infinity)).size(), 7u);
}

}  // namespace
}  // namespace stiction
