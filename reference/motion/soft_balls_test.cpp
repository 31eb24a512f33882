// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/motion/soft_balls.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/limit/limit_scenes.h"

namespace stiction::reference {
namespace {

TEST(SoftBalls, HertzContactOfATextbook) {
  // A steel ball of 10 mm diameter on a steel plate under 100 N, E = 210 GPa, ν = 0.3:
  // E* = 115.4 GPa, a = 0.1481 mm, δ = 4.387 µm (by hand from a³ = 3FR/(4E*), δ = a²/R).
  const HertzContact contact = hertz_contact(100.0, 5e-3, 210e9 / (2.0 * (1.0 - 0.09)));
  EXPECT_NEAR(contact.patch, 1.481e-4, 1e-7);
  EXPECT_NEAR(contact.approach, 4.387e-6, 1e-8);
}

TEST(SoftBalls, PressureCarriesTheForce) {
  // p(ρ) = (2E*/πR) √(a² − ρ²), integrated over the patch: 4E*a³/(3R).
  const double modulus = 3e5, radius = 0.07, force = 42.0;
  const HertzContact contact = hertz_contact(force, radius, modulus);
  EXPECT_NEAR(4.0 * modulus * std::pow(contact.patch, 3) / (3.0 * radius), force, 1e-12 * force);
}

TEST(SoftBalls, StiffOnesNeedWhatRigidOnesDo) {
  SoftFourBalls balls;
  const double rigid = four_ball_thresholds(balls.ratio).ball;
  balls.youngs_modulus = 1e15;
  EXPECT_NEAR(soft_four_ball_threshold(balls).friction, rigid, 1e-8);  // δ ~ 1e-8 m
  // Softer ones need more, ∝ E^(−2/3) to first order: 64 times as stiff, a sixteenth of it. The
  // second order is δ/r = 1 % of it.
  balls.youngs_modulus = 1e7;
  const double soft = soft_four_ball_threshold(balls).friction - rigid;
  balls.youngs_modulus *= 64.0;
  const double stiff = soft_four_ball_threshold(balls).friction - rigid;
  EXPECT_GT(soft, 0.0);
  EXPECT_NEAR(soft / stiff, 16.0, 0.02 * 16.0);
}

TEST(SoftBalls, NormalForceBetweenIsAThirdOfTheTopsWeight) {
  // By the equilibrium of the rigid scene, solved by the exact limit analysis.
  const LimitProblem scene = four_ball_pyramid(1.75, 1.0);
  const LimitFeasibility rest = equilibrium(scene, 0.3);
  ASSERT_EQ(rest.answer, Equilibrium::exists);
  const double third = scene.bodies[0].mass * 9.81 / 3.0;
  for (int k = 0; k < 3; ++k) {
    const auto c = static_cast<std::size_t>(k);
    EXPECT_NEAR(rest.forces.col(k).dot(scene.contacts[c].normal), third, 1e-6 * third);
  }
}

}  // namespace
}  // namespace stiction::reference
