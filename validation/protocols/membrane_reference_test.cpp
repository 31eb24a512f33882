// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/membrane_reference.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace stiction {
namespace {

TEST(MembraneReference, DoesNotDependOnThePartsThatTheSlopeTurnsIn) {
  const MembraneReference coarse = membrane_reference({}, 5.2, 0.026, 160);
  const MembraneReference fine = membrane_reference({}, 5.2, 0.026, 640);
  ASSERT_EQ(coarse.place.size(), fine.place.size());
  for (std::size_t k = 0; k < fine.place.size(); ++k) {
    // Order 2 in parts of 5 ms at 0.4 m/s.
    EXPECT_NEAR(coarse.place[k], fine.place[k], 1e-4) << fine.time[k];
  }
}

TEST(MembraneReference, TheBoxSticksOnTheFirstSlopeAndRestsBehindMidSpan) {
  const MembraneSetup setup;
  const MembraneReference found = membrane_reference(setup, 5.2, 0.026);
  EXPECT_NEAR(found.place.front(), setup.start, 0.03 * setup.length) << "but for the stretch";
  EXPECT_EQ(found.kinetic[2], 0.0);
  EXPECT_EQ(found.kinetic.back(), 0.0);
  EXPECT_GT(found.place.back(), 0.6 * found.length);
  // An undamped oscillator about mid-span from rest stops as far behind it, but for the slope that
  // is still turning when it starts.
  EXPECT_NEAR(found.place.back(), found.length - found.place.front(), 0.03 * found.length);
}

TEST(MembraneReference, WithMoreFrictionThanSlopeItStays) {
  const MembraneReference found = membrane_reference({.friction = 0.9}, 5.2, 0.026);
  EXPECT_EQ(*std::max_element(found.kinetic.begin(), found.kinetic.end()), 0.0);
}

}  // namespace
}  // namespace stiction
