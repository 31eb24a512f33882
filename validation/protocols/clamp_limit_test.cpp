// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/clamp_limit.h"

#include <gtest/gtest.h>

namespace stiction {
namespace {

// The bracket's width, and the residual that the programs allow.
constexpr double kRelative = 2e-6;

void expect_limit(const ClampSetup& setup, double newtons) {
  const ClampLimit limit = clamp_limit(setup);
  EXPECT_LE(limit.lower, newtons * (1.0 + kRelative));
  EXPECT_GE(limit.upper, newtons * (1.0 - kRelative));
  EXPECT_NEAR(limit.upper, limit.lower, 4.0 * kRelative * newtons);
}

TEST(ClampLimit, StraightClampsNeedHalfTheWeightOverMu) {
  ClampSetup setup;
  for (const int boxes : {1, 3}) {
    for (const bool rigid : {false, true}) {
      setup.boxes = boxes;
      setup.rigid = rigid;
      expect_limit(setup, boxes * setup.box_mass * setup.fall / (2.0 * setup.friction));
    }
  }
}

// Narrow bars a third of the width apart. Each presses where it is nearest to the other, on the
// edge that it ends with: N = m g/(2 (μ − (Δh − h)/w)), h their height.
TEST(ClampLimit, OffsetBarsTakeTheirShareOfFriction) {
  ClampSetup setup;
  setup.box_cells = {2, 2, 3};
  setup.offset = setup.width / 3.0;
  setup.bar = Vec3(0.02, 0.14, 0.025);
  setup.bar_cells = {1, 1, 1};
  setup.friction = 0.6;
  EXPECT_EQ(clamp_points(setup, 1.0).contacts.size(), 2u * (3u + 4u)) << "vertices and corners";
  expect_limit(setup, setup.box_mass * setup.fall / (2.0 * (0.6 - 1.0 / 3.0 + 0.25)));
}

TEST(ClampLimit, FlushFacesTouchAtTheVerticesOfBothSides) {
  ClampSetup setup;
  setup.flush = true;
  setup.bar = Vec3(0.04, 0.1, 0.1);
  EXPECT_EQ(clamp_points(setup, 1.0).contacts.size(), 2u * 18u);
  expect_limit(setup, setup.box_mass * setup.fall / (2.0 * setup.friction));
}

}  // namespace
}  // namespace stiction
