// SPDX-License-Identifier: BSD-3-Clause
#include "solver/motion/integrate.h"

#include <gtest/gtest.h>

#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

TEST(Integrate, MovesPositionsWithTheCorrectedVelocities) {
  State state;
  state.position = {{Vec3(1, 2, 3), test::kNaN}};
  state.velocity = {{Vec3::Constant(test::kNaN), 4.0}};  // the old velocity must not be used
  std::vector<Velocity> corrected = {{Vec3(8, 0, -16), 4.0}};
  integrate(0.25, corrected, state);
  EXPECT_EQ(state.position[0].x, Vec3(3, 2, -1));
  EXPECT_EQ(state.velocity[0].v, Vec3(8, 0, -16));
  EXPECT_EQ(state.velocity[0].inverse_mass, 4.0);
}

}  // namespace
}  // namespace stiction
