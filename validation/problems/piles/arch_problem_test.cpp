// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/piles/arch_problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stiction {
namespace {

// Straight-edged blocks, true centroids: 0.102527 by an independent program; 27 blocks 0.106721.
TEST(ArchProblem, LeastThicknessIsTheKnownOne) {
  EXPECT_NEAR(least_thickness({.blocks = 13}), 0.102527, 2e-6);
  EXPECT_NEAR(least_thickness({.blocks = 27}), 0.106721, 2e-6);
}

TEST(ArchProblem, BlocksFillTheRingBetweenTheirJoints) {
  const ArchSetup setup;
  const double angle = std::numbers::pi / setup.blocks;
  const double area = setup.radius * setup.thickness * std::sin(angle);
  for (const ProblemBody& body : arch_problem(setup).bodies) {
    EXPECT_NEAR(body.mass, setup.density * area * setup.depth, 1e-9 * body.mass);
  }
}

}  // namespace
}  // namespace stiction
