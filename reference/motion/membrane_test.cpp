// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/motion/membrane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace stiction::reference {
namespace {

/// The paper's setting: μ = 0.6 = tan 30.96°.
MembraneProblem paper() {
  MembraneProblem p;
  p.tension = 400.0;
  p.length = 1.0;
  p.own_load = 2.0;
  p.slope = std::atan(0.6);
  p.friction = 0.6;
  p.box_load = 1.0 * p.gravity * std::cos(p.slope);
  p.start = 0.2;
  p.speed = 0.05;
  return p;
}

TEST(Membrane, LinearLawStopsWhereTheClosedFormSays) {  // analytic
  for (const double speed : {0.0, 0.02, 0.1}) {
    for (const double friction : {0.58, 0.6, 0.62}) {
      MembraneProblem p = paper();
      p.speed = speed;
      p.friction = friction;
      const MembraneMotion motion = membrane_motion(p, MembraneLaw::linear, 20.0, 50);
      const double expected = membrane_stop(p);
      if (expected < p.length) {
        ASSERT_EQ(motion.end, MembraneEnd::stops);
        // Relative tolerance 1e-12 a step, some hundred steps.
        EXPECT_NEAR(motion.end_position, expected, 1e-10);
        EXPECT_EQ(motion.samples.back().velocity, 0.0);
        EXPECT_EQ(motion.samples.back().position, motion.end_position);
      } else {
        EXPECT_EQ(motion.end, MembraneEnd::leaves);
        EXPECT_EQ(motion.end_position, p.length);
      }
    }
  }
}

TEST(Membrane, AtTheCriticalSlopeTheClosedFormIsTheOneOfTheCase) {
  const MembraneProblem p = paper();
  const double kappa = p.gravity * std::cos(p.slope) * (1.0 + 0.36) *
                       (p.box_load / (p.tension * p.length) + p.own_load / p.tension);
  EXPECT_NEAR(membrane_stop(p), 0.5 + std::sqrt(0.09 + 0.0025 / kappa), 1e-12);
  EXPECT_NEAR(membrane_acceleration(p, MembraneLaw::linear, 0.3), kappa * 0.2, 1e-14);
}

TEST(Membrane, KineticEnergyIsSymmetricAboutMidSpan) {  // analytic, from rest at tan θ = μ
  MembraneProblem p = paper();
  p.speed = 0.0;
  const double half_period = M_PI / std::sqrt(membrane_stiffness(p));
  const MembraneMotion motion = membrane_motion(p, MembraneLaw::linear, half_period, 100);
  const auto energy = [&](std::size_t k) { return motion.samples[k].kinetic_energy; };
  for (std::size_t k = 0; k <= 50; ++k) {
    EXPECT_NEAR(energy(k), energy(100 - k), 1e-10 * energy(50));
    EXPECT_LE(energy(k), energy(50));
  }
  EXPECT_NEAR(motion.samples[50].position, 0.5, 1e-10);
  // ½ m κ (ℓ/2 − s₀)².
  EXPECT_NEAR(energy(50), 0.5 * membrane_stiffness(p) * 0.09, 1e-10);
}

/// The contact resolved: ∫ τ(α) (n + μ t) dα with τ the tension along it, by Simpson's rule.
struct Contact {
  double along = 0.0;   ///< pull on the membrane downhill, N
  double across = 0.0;  ///< load on the membrane, N
};

Contact integrate_contact(double right_tension, double left, double right, double friction) {
  constexpr int kSteps = 200;
  Contact sum;
  for (int k = 0; k <= kSteps; ++k) {
    const double alpha = right + (left - right) * k / kSteps;
    const double tension = right_tension * std::exp(friction * (alpha - right));
    const double weight =
        (k == 0 || k == kSteps ? 1.0 : (k % 2 == 1 ? 4.0 : 2.0)) * (left - right) / (3.0 * kSteps);
    // Pressure acts into the membrane, (−sin α, cos α); friction drags it downhill, (cos α, sin α).
    sum.along += weight * tension * (-std::sin(alpha) + friction * std::cos(alpha));
    sum.across += weight * tension * (std::cos(alpha) + friction * std::sin(alpha));
  }
  return sum;
}

TEST(Membrane, FullLawBalancesForcesOfAResolvedContact) {  // independent road to the same F
  for (const double s : {0.1, 0.35, 0.5, 0.8}) {
    for (const double tension : {30.0, 400.0}) {
      MembraneProblem p = paper();
      p.tension = tension;
      const double pull =
          p.box_load *
          (p.gravity * std::sin(p.slope) - membrane_acceleration(p, MembraneLaw::full, s)) /
          (p.gravity * std::cos(p.slope));
      // The shape, from its two straight-forward equations, with the elastic share of the pull.
      const double left = tension + pull * (1.0 - s);
      const double right = tension - pull * s;
      const double sag = (p.box_load + 0.5 * p.own_load) / (left / s + right / (1.0 - s));
      const double slope_left = sag / s - 0.5 * p.own_load * s / left;
      const double slope_right = -sag / (1.0 - s) + 0.5 * p.own_load * (1.0 - s) / right;
      const Contact contact =
          integrate_contact(right * std::hypot(1.0, slope_right), std::atan(slope_left),
                            std::atan(slope_right), p.friction);
      // Simpson: (Δα)⁵/(180 · 200⁴) τ, far below; Brent's root: 1e-15 of the tension.
      EXPECT_NEAR(contact.along, pull, 1e-11);
      EXPECT_NEAR(contact.across, p.box_load, 1e-11);
    }
  }
}

TEST(Membrane, FullLawTendsToTheLinearOneAtFirstOrder) {
  // Slopes and P/T go as 1/T, and so does the relative difference of the accelerations.
  double last = 0.0;
  for (const double tension : {4e2, 8e2, 1.6e3, 3.2e3}) {
    MembraneProblem p = paper();
    p.tension = tension;
    const double linear = membrane_acceleration(p, MembraneLaw::linear, 0.3);
    const double difference = membrane_acceleration(p, MembraneLaw::full, 0.3) / linear - 1.0;
    if (last != 0.0) {
      EXPECT_NEAR(last / difference, 2.0, 0.1) << "T = " << tension;
    }
    last = difference;
  }
  EXPECT_LT(std::abs(last), 0.01);
}

TEST(Membrane, FullMotionStopsNearTheLinearOneAndItsEnergyPeaksNearTheMiddle) {
  MembraneProblem p = paper();
  p.tension = 4000.0;
  p.speed = 0.01;
  const MembraneMotion full = membrane_motion(p, MembraneLaw::full, 60.0, 600);
  ASSERT_EQ(full.end, MembraneEnd::stops);
  // First order in slope and P/T, both below 0.4 %.
  EXPECT_NEAR(full.end_position, membrane_stop(p), 0.01);
  const auto peak = std::max_element(
      full.samples.begin(), full.samples.end(),
      [](const auto& a, const auto& b) { return a.kinetic_energy < b.kinetic_energy; });
  EXPECT_NEAR(peak->position, 0.5, 0.01);
}

TEST(Membrane, EndsAreTold) {
  MembraneProblem p = paper();
  p.speed = 3.0;
  EXPECT_EQ(membrane_motion(p, MembraneLaw::linear, 5.0, 10).end, MembraneEnd::leaves);
  EXPECT_EQ(membrane_motion(p, MembraneLaw::full, 5.0, 10).end, MembraneEnd::leaves);
  p.speed = 0.01;
  EXPECT_EQ(membrane_motion(p, MembraneLaw::linear, 0.01, 10).end, MembraneEnd::moves);
  p.speed = 0.0;
  p.start = 0.6;  // behind the middle, uphill from the start: sticks where it is
  for (const MembraneLaw law : {MembraneLaw::linear, MembraneLaw::full}) {
    const MembraneMotion motion = membrane_motion(p, law, 1.0, 4);
    EXPECT_EQ(motion.end, MembraneEnd::stops);
    EXPECT_EQ(motion.end_position, 0.6);
    EXPECT_EQ(motion.samples.size(), 5);
  }
}

TEST(Membrane, ResultsDontDependOnTheSampling) {
  const MembraneProblem p = paper();
  // A whole period of the oscillator in one interval, and v > 0 at its end: rest must not be
  // missed.
  const double period = 2.0 * M_PI / std::sqrt(membrane_stiffness(p));
  const double one = membrane_motion(p, MembraneLaw::full, period, 1).end_position;
  EXPECT_NEAR(membrane_motion(p, MembraneLaw::linear, period, 1).end_position, membrane_stop(p),
              1e-10);
  for (const int intervals : {7, 100}) {
    EXPECT_NEAR(membrane_motion(p, MembraneLaw::full, period, intervals).end_position, one, 1e-10);
  }
}

TEST(Membrane, RefusesWhatMakesNoSense) {
  MembraneProblem p = paper();
  p.tension = 0.0;
  EXPECT_THROW(membrane_motion(p, MembraneLaw::linear, 1.0, 1), std::invalid_argument);
  p = paper();
  p.box_load = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(membrane_acceleration(p, MembraneLaw::full, 0.5), std::invalid_argument);
  p = paper();
  EXPECT_THROW(membrane_acceleration(p, MembraneLaw::full, 1.5), std::invalid_argument);
  EXPECT_THROW(membrane_motion(p, MembraneLaw::full, 1.0, 0), std::invalid_argument);
  p.tension = 0.5;  // less than the box pulls: the lower part would have to push
  EXPECT_THROW(membrane_acceleration(p, MembraneLaw::full, 0.9), std::domain_error);
}

}  // namespace
}  // namespace stiction::reference
