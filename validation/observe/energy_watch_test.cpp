// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/observe/energy_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stiction {
namespace {

// Of an energy over the window from 1 to 3 s.
template <class Energy>
double growth(Energy energy, double mass = 1.0) {
  EnergyWatch watch(1.0, 3.0, mass);
  for (int k = 1; k <= 2 * EnergyWatch::kSamples; ++k) {
    const double time = 1.0 + 2.0 * k / (2.0 * EnergyWatch::kSamples);
    watch.add(time, energy(time));
  }
  return watch.growth();
}

TEST(EnergyWatch, SeesGrowth) {
  EXPECT_NEAR(growth([](double t) { return t <= 2.0 ? 1.0 : 1.5; }), 0.5, 1e-12);
  EXPECT_GT(growth([](double t) { return 1e-9 * std::exp(t); }), EnergyWatch::allowance());
}

TEST(EnergyWatch, AllowsDecayAndAnUndampedVibrationOfAnyFrequency) {
  EXPECT_LT(growth([](double t) { return std::exp(-t); }), 0.0);
  for (double omega = 50.0; omega < 5000.0; omega *= 1.13) {
    const double grown = growth([&](double t) { return std::pow(std::sin(omega * t), 2); });
    EXPECT_LE(grown, EnergyWatch::allowance()) << omega;
  }
}

TEST(EnergyWatch, TakesWhatMovesByRoundOffForRest) {
  EXPECT_EQ(growth([](double t) { return 1e-26 * std::exp(t); }), 0.0);
  EXPECT_GT(growth([](double t) { return 1e-26 * std::exp(t); }, 1e-3), 0.0) << "a light body";
  EXPECT_EQ(growth([](double) { return 0.0; }), 0.0);
}

TEST(EnergyWatch, TakesWhatIsNoNumberOrWasNotSeenForGrowth) {
  EXPECT_EQ(growth([](double t) { return t < 2.5 ? 1.0 : NAN; }),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(EnergyWatch(0.0, 1.0, 1.0).growth(), std::numeric_limits<double>::infinity());
}

TEST(EnergyWatch, LeavesOutWhatLiesOutsideItsWindow) {
  EnergyWatch watch(1.0, 3.0, 1.0);
  for (const double time : {0.5, 1.0, 3.5}) watch.add(time, 1e9);
  watch.add(1.5, 2.0);
  watch.add(3.0, 1.0);
  EXPECT_DOUBLE_EQ(watch.first_half(), 2.0);
  EXPECT_DOUBLE_EQ(watch.growth(), -0.5);
}

}  // namespace
}  // namespace stiction
