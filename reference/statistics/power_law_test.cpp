// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/statistics/power_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace stiction::reference {
namespace {

TEST(PowerLaw, IsFoundAgain) {
  std::vector<double> x, y;
  for (double value = 1.0; value < 1e4; value *= 3.0) {
    x.push_back(value);
    y.push_back(5.0 * std::pow(value, 1.5));
  }
  const PowerLaw law = fit_power_law(x, y);
  EXPECT_NEAR(law.exponent, 1.5, 1e-14);
  EXPECT_NEAR(law.factor, 5.0, 1e-13);
  EXPECT_LT(law.exponent_margin, 1e-13);
}

// Points (0, 0), (1, 1), (2, 1) in logarithms: slope ½, residual 1/6 with one degree of freedom,
// variance of the slope 1/12, t = 12.706.
TEST(PowerLaw, ItsMarginIsStudents) {
  const double e = std::exp(1.0);
  const PowerLaw law = fit_power_law({1.0, e, e * e}, {1.0, e, e});
  EXPECT_NEAR(law.exponent, 0.5, 1e-15);
  EXPECT_NEAR(law.exponent_margin, 12.706204736 / std::sqrt(12.0), 1e-9);
}

TEST(PowerLaw, OfTwoPointsHasNoMargin) {
  EXPECT_TRUE(std::isinf(fit_power_law({1.0, 2.0}, {1.0, 2.0}).exponent_margin));
}

TEST(PowerLaw, RefusesWhatHasNone) {
  EXPECT_THROW(fit_power_law({}, {}), std::invalid_argument);
  EXPECT_THROW(fit_power_law({1.0, 2.0}, {1.0}), std::invalid_argument);
  EXPECT_THROW(fit_power_law({2.0, 2.0}, {1.0, 3.0}), std::invalid_argument);
  EXPECT_THROW(fit_power_law({1.0, 2.0}, {0.0, 3.0}), std::invalid_argument);
  EXPECT_THROW(fit_power_law({1.0, NAN}, {1.0, 3.0}), std::invalid_argument);
}

}  // namespace
}  // namespace stiction::reference
