// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/estimate/extrapolation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stiction {
namespace {

// q₀ = 3, q(h) = 3 + 0.4 hᵖ at h = 1, 1/4, 1/16.
double value(double order, int refinement) {
  return 3.0 + 0.4 * std::pow(std::pow(4.0, -refinement), order);
}

TEST(Extrapolation, FindsLimitAndOrderOfAPower) {
  for (const double order : {0.5, 1.0, 2.0}) {
    const Extrapolation found = extrapolate(value(order, 0), value(order, 1), value(order, 2), 4.0);
    // Differences of numbers of order 3 lose a digit or two.
    EXPECT_NEAR(found.order, order, 1e-12);
    EXPECT_NEAR(found.limit, 3.0, 1e-14);
    EXPECT_NEAR(extrapolate_with_order(value(order, 1), value(order, 2), 4.0, order), 3.0, 1e-14);
  }
}

TEST(Extrapolation, IsNoNumberWhereNothingConverges) {
  EXPECT_TRUE(std::isnan(extrapolate(1.0, 2.0, 1.5, 2.0).limit)) << "swings";
  EXPECT_TRUE(std::isnan(extrapolate(1.0, 2.0, 4.0, 2.0).limit)) << "grows";
  EXPECT_TRUE(std::isnan(extrapolate(1.0, 2.0, 2.0, 2.0).limit)) << "stands still at the end";
  EXPECT_TRUE(std::isnan(extrapolate(1.0, std::nan(""), 2.0, 2.0).order));
}

}  // namespace
}  // namespace stiction
