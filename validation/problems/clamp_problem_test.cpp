// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/clamp_problem.h"

#include <gtest/gtest.h>

namespace stiction {
namespace {

ClampThreshold threshold_of(double width) {
  const Case which{.name = "clamp", .title = "t"};
  CaseRun run(which, find_engine("stiction"), {{"method", "quiet"}}, 1.0);
  run.bodies_are_thrown();
  ClampSetup setup;
  setup.elasticity.poisson_ratio = 0.0;
  return clamp_threshold(run, setup,
                         {.guess = 3.65e-4, .step = 4e-7, .reach = 1e-5, .width = width});
}

// Next to the threshold a clamp loses twice as much of its force under load as of that before
// gravity: scaled by the latter, the bracket of the wider search did not hold the force at which
// the clamp gives.
TEST(ClampThreshold, ItsBracketHoldsTheForceThatANarrowerSearchFinds) {
  const ClampThreshold wide = threshold_of(2e-7), fine = threshold_of(2e-8);
  EXPECT_TRUE(wide.holds.holds && !wide.fails.holds);
  EXPECT_TRUE(fine.holds.holds && !fine.fails.holds);
  EXPECT_LE(wide.lower, wide.fails.force) << "nothing turns: no fold";
  EXPECT_LE(wide.lower, fine.lower);
  EXPECT_GE(wide.upper, fine.upper);
  EXPECT_LT(fine.half(), 0.25 * wide.half());
  EXPECT_LT(wide.half(), 1e-3 * wide.middle());
}

}  // namespace
}  // namespace stiction
