// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/piles/ball_pyramid_problem.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "reference/limit/limit_scenes.h"

namespace stiction {
namespace {

// A pyramid of coarse balls, far from at rest: enough for what its contacts say.
std::unique_ptr<Engine> some_pyramid(const BallPyramidSetup& setup) {
  auto engine =
      find_engine("stiction")
          .make({{"ball", std::to_string(setup.frequency)}, {"method", "quiet"}, {"dt", "5e-4"}});
  engine->load(ball_pyramid_problem(setup), {});
  engine->advance(800);
  return engine;
}

BallPyramidSetup coarse() {
  BallPyramidSetup setup;
  setup.frequency = 2;
  setup.elasticity = {.youngs_modulus = 3e5, .poisson_ratio = 0.3, .damping_time = 1e-4};
  setup.friction = 1.0;
  return setup;
}

TEST(BallPyramidProblem, LimitProblemHoldsEachContactToItsForceWhereAsked) {
  const BallPyramidSetup setup = coarse();
  const auto engine = some_pyramid(setup);
  const auto any = limit_problem(*engine, setup, engine->contacts(), ContactLoads::kAny);
  const auto measured = limit_problem(*engine, setup, engine->contacts(), ContactLoads::kMeasured);
  EXPECT_TRUE(any.clamps.empty());
  ASSERT_GE(any.contacts.size(), 6U);  // three balls on the ground, one on them
  ASSERT_EQ(measured.contacts.size(), any.contacts.size());
  ASSERT_EQ(measured.clamps.size(), any.contacts.size());
  std::size_t c = 0;
  for (const ContactSample& sample : engine->contacts()) {
    if (!(sample.normal_force > 0.0)) continue;
    EXPECT_EQ(measured.clamps[c].contacts, std::vector<int>{static_cast<int>(c)});
    EXPECT_EQ(measured.clamps[c].total, sample.normal_force);
    ++c;
  }
  EXPECT_EQ(c, measured.clamps.size());
}

TEST(BallPyramidProblem, SmoothThresholdIsOfTheSetupsBalls) {
  BallPyramidSetup setup = coarse();
  const double rigid = reference::four_ball_thresholds(setup.ratio).ball;
  const double soft = smooth_threshold(setup).friction;
  EXPECT_GT(soft, rigid + 0.005);
  EXPECT_LT(soft, rigid + 0.02);
  // Only ρ g r/E counts.
  setup.radius *= 2.0;
  setup.elasticity.youngs_modulus *= 2.0;
  EXPECT_NEAR(smooth_threshold(setup).friction, soft, 1e-14);
  setup.elasticity.youngs_modulus = 1e15;
  EXPECT_NEAR(smooth_threshold(setup).friction, rigid, 1e-8);
}

}  // namespace
}  // namespace stiction
