// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/exact_momentum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace stiction::reference {
namespace {

using Velocities = std::vector<Eigen::Vector3d>;

TEST(ExactMomentum, KeepsWhatAPlainSumLoses) {
  // 1e16 + 1 − 1e16: in doubles the 1 is gone.
  const Velocities rest(3, Eigen::Vector3d::Zero());
  const Velocities now = {{1e16, 0, 0}, {1, 0, 0}, {-1e16, 0, 0}};
  EXPECT_EQ(1e16 + 1.0 - 1e16, 0.0);
  EXPECT_EQ(exact_momentum_change({1, 1, 1}, rest, now).x(), 1.0);
  EXPECT_EQ(exact_momentum_change({1, 1, 1}, now, rest).x(), -1.0);
}

TEST(ExactMomentum, IsOfTheDoublesAsTheyAre) {
  // The doubles 0.1 and 0.3 are not a tenth and three: 3 · 0.1 − 0.3 = 2⁻⁵⁵.
  const Eigen::Vector3d change =
      exact_momentum_change({0.1, 0.1, 0.1, 0.3}, Velocities(4, Eigen::Vector3d::Zero()),
                            {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, -1, 0}});
  EXPECT_EQ(change, Eigen::Vector3d(0.0, std::ldexp(1.0, -55), 0.0));
}

TEST(ExactMomentum, RefusesWhatItCannotReckon) {
  const Velocities one(1, Eigen::Vector3d::Zero());
  EXPECT_THROW(exact_momentum_change({1, 2}, one, one), std::invalid_argument);
  EXPECT_THROW(exact_momentum_change({std::nan("")}, one, one), std::invalid_argument);
  EXPECT_THROW(exact_momentum_change({1}, one, {{INFINITY, 0, 0}}), std::invalid_argument);
}

}  // namespace
}  // namespace stiction::reference
