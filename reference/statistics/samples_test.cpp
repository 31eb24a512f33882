// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/statistics/samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stiction::reference {
namespace {

using Points = std::vector<std::vector<double>>;

// Largest deviation, over boxes [0, x) × [0, y) of a grid, of the share of points from the area.
double star_discrepancy(const Points& points) {
  double worst = 0.0;
  for (int i = 1; i <= 16; ++i) {
    for (int j = 1; j <= 16; ++j) {
      const double x = i / 16.0, y = j / 16.0;
      const auto inside = std::count_if(points.begin(), points.end(),
                                        [&](const auto& p) { return p[0] < x && p[1] < y; });
      worst = std::max(
          worst,
          std::abs(static_cast<double>(inside) / static_cast<double>(points.size()) - x * y));
    }
  }
  return worst;
}

TEST(Samples, AreInTheUnitCubeAndTheSameEachTime) {
  for (const Sampling method : {Sampling::kSobol, Sampling::kHalton, Sampling::kRandom}) {
    const Points points = unit_samples(method, 3, 100, 7);
    ASSERT_EQ(points.size(), 100u);
    for (const auto& point : points) {
      ASSERT_EQ(point.size(), 3u);
      for (const double x : point) EXPECT_TRUE(x >= 0.0 && x < 1.0) << x;
    }
    EXPECT_EQ(points, unit_samples(method, 3, 100, 7));
    EXPECT_NE(points, unit_samples(method, 3, 100, 8));
  }
}

// Of 1000 points: about (log n)²/n against 1/√n.
TEST(Samples, OfLowDiscrepancyFillTheSquareMoreEvenlyThanRandomOnes) {
  const double random = star_discrepancy(unit_samples(Sampling::kRandom, 2, 1000, 0));
  EXPECT_LT(star_discrepancy(unit_samples(Sampling::kSobol, 2, 1000, 0)), 0.3 * random);
  EXPECT_LT(star_discrepancy(unit_samples(Sampling::kHalton, 2, 1000, 0)), 0.5 * random);
}

TEST(Samples, OfMoreDimensionsThanASequenceHasAreRefused) {
  EXPECT_THROW(unit_samples(Sampling::kSobol, 41, 1, 0), std::invalid_argument);
  EXPECT_THROW(unit_samples(Sampling::kSobol, 0, 1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace stiction::reference
