// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/estimate/convergence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace stiction {
namespace {

std::vector<double> power_law(const std::vector<double>& h, double factor, double order) {
  std::vector<double> error;
  for (const double step : h) error.push_back(factor * std::pow(step, order));
  return error;
}

TEST(ObservedOrder, OfAPowerLawIsItsExponent) {
  const std::vector<double> h = {4e-4, 2e-4, 1e-4, 5e-5};
  for (const double order : {0.5, 1.0, 2.0, 4.0}) {
    // Logarithms of up to 50 are rounded by 1e-14, over a spread of 2.
    EXPECT_NEAR(observed_order(h, power_law(h, 3.0, order)), order, 1e-13);
    EXPECT_NEAR(observed_order(h, power_law(h, -3.0, order)), order, 1e-13) << "errors have signs";
  }
}

TEST(ObservedOrder, IsTheLeastSquaresSlope) {
  // log₂ error = 0, 1, 4 over log₂ h = 0, 1, 2: slope 2.
  EXPECT_NEAR(observed_order({1.0, 2.0, 4.0}, {1.0, 2.0, 16.0}), 2.0, 1e-14);
}

TEST(ObservedOrder, IsNaNWhereAnErrorIsZeroOrNotFinite) {
  for (const double error : {0.0, std::nan(""), HUGE_VAL}) {
    EXPECT_TRUE(std::isnan(observed_order({1.0, 2.0, 4.0}, {1.0, error, 4.0})));
  }
}

TEST(ObservedOrder, DemandsThreePoints) {
  EXPECT_THROW(observed_order({1.0, 2.0}, {1.0, 2.0}), std::logic_error);
  EXPECT_THROW(observed_order({1.0, 2.0, 4.0}, {1.0, 2.0}), std::logic_error);
}

}  // namespace
}  // namespace stiction
