// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/limit/no_tension_column.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stiction::reference {
namespace {

TEST(NoTensionColumn, TopplesLikeARigidBlockWhenItIsStiff) {
  const Column stiff{.height = 0.5, .youngs_modulus = 1e13};
  EXPECT_NEAR(critical_tan(stiff), 0.2, 1e-3 * 0.2);
}

// A cantilever under the transverse load q sin θ: q s L⁴/(8 E I), as long as its lean adds nothing.
TEST(NoTensionColumn, BendsLikeACantileverUnderASmallLoad) {
  const Column column{.height = 0.5, .youngs_modulus = 1e10};
  const double slope = 1e-3;
  const double load = column.weight_density * 0.01 * std::sin(std::atan(slope));
  const double expected = load * std::pow(0.5, 4) / (8.0 * 1e10 * 1e-4 / 12.0);
  EXPECT_NEAR(top_deflection(column, slope), expected, 1e-3 * expected);
}

// Greenhill: an upright column buckles under its own weight at q L³/(E I) = 7.8373.
TEST(NoTensionColumn, BucklesAtGreenhillsHeight) {
  Column column{.youngs_modulus = 1e6};
  const double q = column.weight_density * 0.01, stiffness = 1e6 * 1e-4 / 12.0;
  const double height = std::cbrt(7.8373 * stiffness / q);
  column.height = 0.97 * height;
  EXPECT_TRUE(std::isfinite(top_deflection(column, 1e-6)));
  column.height = 1.03 * height;
  EXPECT_FALSE(std::isfinite(top_deflection(column, 1e-6)));
}

TEST(NoTensionColumn, OfTenSoftCubesTopplesFarBelowTheRigidLimit) {
  const double soft = critical_tan(Column{.height = 1.0}) / 0.1;
  const double stiffer = critical_tan(Column{.height = 1.0, .youngs_modulus = 1e8}) / 0.1;
  EXPECT_GT(soft, 0.5);
  EXPECT_LT(soft, 0.6);
  EXPECT_GT(stiffer, soft);
  EXPECT_LT(stiffer, 1.0);
}

}  // namespace
}  // namespace stiction::reference
