// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/motion/incline_ode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "reference/motion/test_rounding.h"

namespace stiction::reference {
namespace {

using Kind = FrictionalEventKind;

// A load that depends on time only.
template <typename Function>
AccelerationLoad over_time(Function function) {
  return [function](double t, double, double) { return function(t); };
}

AccelerationLoad constant(double value) {
  return over_time([value](double) { return value; });
}

// Expected (analytic): incline.h. A constant acceleration is integrated without truncation error,
// so round-off remains: at most 2 ε of the running value for each of the 100 steps; event times are
// located to 2 ε of the duration. 1e-13 is twice their sum (measured: 7e-15).
TEST(InclineOde, AgreesWithTheClosedFormsOfAStop) {
  for (const double angle : {0.0, 0.1, 0.3, 0.46}) {
    const Incline incline{.angle = angle, .friction = 0.5};
    const double time = stopping_time(incline, 1.5);
    const double distance = stopping_distance(incline, 1.5);
    const FrictionalMotion motion = integrate_frictional_motion(
        incline_loads(incline), {.velocity = 1.5}, 1.5 * time, {.sample_interval = time / 67.0});
    ASSERT_EQ(motion.events.size(), 1u) << angle;
    EXPECT_EQ(motion.events[0].kind, Kind::kSlipToStick);
    // Near the critical slope μ cos θ − sin θ cancels in the loads: condition number a_t/(μ a_n −
    // a_t).
    const double condition = 1.0 + incline.gravity * std::sin(angle) / deceleration(incline);
    EXPECT_NEAR(motion.events[0].time, time, 1e-13 * time + 4.0 * kEpsilon * condition * time);
    EXPECT_NEAR(motion.events[0].position, distance,
                1e-13 * distance + 4.0 * kEpsilon * condition * distance);
    // No creep: exactly at rest to the end.
    EXPECT_TRUE(motion.samples.back().sticking);
    EXPECT_EQ(motion.samples.back().velocity, 0.0);
    EXPECT_EQ(motion.samples.back().position, motion.events[0].position);
  }
}

// Tolerance: 2 ε for each of the 50 steps, and the cancellation g sin θ − μ g cos θ (4.1 − 0.9).
TEST(InclineOde, AcceleratesAboveTheCriticalSlope) {
  const Incline incline{.angle = 0.43, .friction = 0.1};
  const double a = sliding_acceleration(incline);
  const FrictionalMotion motion =
      integrate_frictional_motion(incline_loads(incline), {}, 2.0, {.sample_interval = 0.04});
  EXPECT_TRUE(motion.events.empty());
  ASSERT_EQ(motion.samples.size(), 51u);
  for (const FrictionalSample& sample : motion.samples) {
    EXPECT_NEAR(sample.velocity, a * sample.time, 100.0 * kEpsilon * a * 2.0);
    EXPECT_NEAR(sample.position, a * sample.time * sample.time / 2.0, 100.0 * kEpsilon * a * 2.0);
    EXPECT_FALSE(sample.sticking);
  }
  EXPECT_EQ(motion.samples.back().time, 2.0);
}

// At the critical slope the two loads differ by their rounding only, so v changes by at most
// 2 ε g t, plus ε v for each of the 10 steps.
TEST(InclineOde, KeepsItsSpeedAtTheCriticalSlopeAndSticksFromRest) {
  for (double mu = 0.05; mu < 1.0; mu += 0.05) {
    const FrictionalLoads loads = incline_loads({.angle = std::atan(mu), .friction = mu});
    const FrictionalMotion slide =
        integrate_frictional_motion(loads, {.velocity = 1.0}, 10.0, {.sample_interval = 1.0});
    EXPECT_NEAR(slide.samples.back().velocity, 1.0, kEpsilon * (2.0 * 9.81 * 10.0 + 10.0)) << mu;
    const FrictionalMotion rest =
        integrate_frictional_motion(loads, {}, 10.0, {.sample_interval = 1.0});
    EXPECT_TRUE(rest.events.empty()) << mu;
    EXPECT_EQ(rest.samples.back().position, 0.0) << mu;
  }
}

// Launched uphill on a steep slope: decelerates with g (sin θ + μ cos θ), turns without sticking,
// and comes down with g (sin θ − μ cos θ). Tolerance as for the stop.
TEST(InclineOde, TurnsRoundAboveTheCriticalSlope) {
  const Incline incline{.angle = 0.6, .friction = 0.3};
  const double up = incline.gravity * (std::sin(0.6) + 0.3 * std::cos(0.6));
  const FrictionalMotion motion = integrate_frictional_motion(
      incline_loads(incline), {.velocity = -2.0}, 1.0, {.sample_interval = 0.01});
  ASSERT_EQ(motion.events.size(), 1u);
  EXPECT_EQ(motion.events[0].kind, Kind::kReversal);
  EXPECT_NEAR(motion.events[0].time, 2.0 / up, 1e-13);
  EXPECT_NEAR(motion.events[0].position, -2.0 / up, 1e-13);
  EXPECT_NEAR(motion.samples.back().velocity, sliding_acceleration(incline) * (1.0 - 2.0 / up),
              1e-13);
}

// A push p for a time T on level ground. Below μg nothing may move, and release leaves nothing
// behind; above, v = (p − μg)T, then a stop v/(μg) later. T lies off the samples, so that a jump
// stepped over would show as an error of the order of the sample interval.
TEST(InclineOde, PushAndRelease) {
  const double bound = 0.4 * 10.0;
  const double release = 0.7301;
  const auto push = [&](double p) {
    const FrictionalLoads loads{
        .tangential = over_time([=](double t) { return t < release ? p : 0.0; }),
        .normal = constant(10.0),
        .friction = 0.4,
        .breakpoints = {release}};
    return integrate_frictional_motion(loads, {}, 3.0, {.sample_interval = 0.1});
  };
  const FrictionalMotion held = push(0.99 * bound);
  EXPECT_TRUE(held.events.empty());
  EXPECT_EQ(held.samples.back().position, 0.0);

  const FrictionalMotion moved = push(1.5 * bound);
  const double speed = 0.5 * bound * release;
  ASSERT_EQ(moved.events.size(), 1u);
  EXPECT_NEAR(moved.events[0].time, release + speed / bound, 1e-13);
  EXPECT_NEAR(moved.events[0].position, speed * release / 2.0 + speed * speed / (2.0 * bound),
              1e-13);

  // A push that comes late: stick to slip happens at its breakpoint exactly.
  const FrictionalLoads late{
      .tangential = over_time([=](double t) { return t < release ? 0.0 : 5.0; }),
      .normal = constant(10.0),
      .friction = 0.4,
      .breakpoints = {release}};
  const FrictionalMotion delayed =
      integrate_frictional_motion(late, {}, 2.0, {.sample_interval = 0.1});
  ASSERT_EQ(delayed.events.size(), 1u);
  EXPECT_EQ(delayed.events[0].kind, Kind::kStickToSlip);
  EXPECT_EQ(delayed.events[0].time, release);
  EXPECT_NEAR(delayed.samples.back().velocity, 2.0 - release, 1e-13);
}

// With no error control to repair it (tolerance 1), a load taken from beyond its jump, or a
// derivative kept from before it, would leave an error of the order of a step. Pieces of constant
// acceleration are exact for any step: v = 4 · 0.73 − 2 · 0.5 − 1.2 · 1. Tolerance: 5 steps of 2 ε
// · 4 m/s.
TEST(InclineOde, JumpsCostNoAccuracy) {
  const FrictionalLoads loads{.tangential = over_time([](double t) {
                                return t < 0.73 ? 5.0 : t < 1.23 ? -1.0 : -0.2;
                              }),
                              .normal = constant(10.0),
                              .friction = 0.1,
                              .breakpoints = {1.23, 0.73}};
  const FrictionalMotion motion = integrate_frictional_motion(
      loads, {}, 2.23, {.sample_interval = 5.0, .relative_tolerance = 1.0});
  ASSERT_EQ(motion.samples.size(), 2u);
  EXPECT_NEAR(motion.samples.back().velocity, 4.0 * 0.73 - 2.0 * 0.5 - 1.2, 40.0 * kEpsilon);
}

// a_t = r t sticks until t_s = μ a_n/r, then v = r (t − t_s)²/2 and x = r (t − t_s)³/6: polynomials
// that the method integrates exactly. Tolerance: 40 steps of 2 ε, and 2 ε T/t in t_s.
TEST(InclineOde, RampLeavesStickAtTheBound) {
  const FrictionalLoads loads{.tangential = over_time([](double t) { return 3.0 * t; }),
                              .normal = constant(10.0),
                              .friction = 0.25,
                              .breakpoints = {}};
  const FrictionalMotion motion =
      integrate_frictional_motion(loads, {}, 2.0, {.sample_interval = 0.05});
  const double start = 2.5 / 3.0;
  ASSERT_EQ(motion.events.size(), 1u);
  EXPECT_EQ(motion.events[0].kind, Kind::kStickToSlip);
  EXPECT_NEAR(motion.events[0].time, start, 4.0 * kEpsilon * 2.0);
  EXPECT_NEAR(motion.samples.back().velocity, 1.5 * std::pow(2.0 - start, 2), 1e-13);
  EXPECT_NEAR(motion.samples.back().position, 0.5 * std::pow(2.0 - start, 3), 1e-13);
}

// Without friction and with v = (t − 1)² − 0.01 the velocity is negative only from 0.9 to 1.1,
// inside a single step: both ends of the step see v > 0. dt/dv = 1/(2 · 0.1) turns ε into 5 ε.
TEST(InclineOde, FindsADoubleZeroWithinOneStep) {
  const FrictionalLoads loads{.tangential = over_time([](double t) { return 2.0 * (t - 1.0); }),
                              .normal = constant(1.0),
                              .friction = 0.0,
                              .breakpoints = {}};
  const FrictionalMotion motion =
      integrate_frictional_motion(loads, {.velocity = 0.99}, 2.0, {.sample_interval = 2.0});
  ASSERT_EQ(motion.events.size(), 2u);
  EXPECT_NEAR(motion.events[0].time, 0.9, 1e-14 * 5.0);
  EXPECT_NEAR(motion.events[1].time, 1.1, 1e-14 * 5.0);
  EXPECT_EQ(motion.events[0].kind, Kind::kReversal);
}

// A negative normal load is separation: no friction, so the speed stays.
TEST(InclineOde, SeparationHasNoFriction) {
  const FrictionalLoads loads{
      .tangential = constant(0.0), .normal = constant(-5.0), .friction = 0.5, .breakpoints = {}};
  const FrictionalMotion motion =
      integrate_frictional_motion(loads, {.velocity = 1.0}, 1.0, {.sample_interval = 0.1});
  EXPECT_EQ(motion.samples.back().velocity, 1.0);
}

struct Oscillator {
  double omega = 3.0;   // √(k/m), rad/s
  double delta = 0.1;   // μN/k, m
  double start = 1.07;  // m

  FrictionalMotion run(const FrictionalOdeOptions& options, double duration) const {
    const double stiffness = omega * omega;
    const FrictionalLoads loads{
        .tangential = [stiffness](double, double x, double) { return -stiffness * x; },
        .normal = constant(stiffness * delta / 0.5),
        .friction = 0.5,
        .breakpoints = {}};
    return integrate_frictional_motion(loads, {.position = start}, duration, options);
  }
};

// Expected (analytic): turning points x_n = (−1)ⁿ (x_0 − 2nδ) at t_n = nπ/ω, rest at the first
// |x_n| ≤ δ: 1.07, −0.87, 0.67, −0.47, 0.27, −0.07. Tolerance: ωΔt = 0.15 leaves an
// eighth-order step nothing but round-off, 2 ε for each of 160 steps, tripled (measured: 4e-15).
TEST(CoulombOscillator, LosesTwoDeltaPerHalfCycleAndRests) {
  const Oscillator oscillator;
  const FrictionalMotion motion = oscillator.run({.sample_interval = 0.05}, 8.0);
  ASSERT_EQ(motion.events.size(), 5u);
  for (std::size_t n = 1; n <= 5; ++n) {
    const FrictionalEvent& event = motion.events[n - 1];
    const double number = static_cast<double>(n);
    const double amplitude = oscillator.start - 2.0 * number * oscillator.delta;
    EXPECT_EQ(event.kind, n < 5 ? Kind::kReversal : Kind::kSlipToStick);
    EXPECT_NEAR(event.position, n % 2 == 0 ? amplitude : -amplitude, 2e-13);
    EXPECT_NEAR(event.time, number * std::numbers::pi / oscillator.omega, 2e-13);
  }
  EXPECT_EQ(motion.samples.back().velocity, 0.0);
  EXPECT_EQ(motion.samples.back().position, motion.events.back().position);
  // In the first half-cycle x = δ + (x_0 − δ) cos ωt, about a centre that friction shifts by δ.
  for (const FrictionalSample& sample : motion.samples) {
    if (sample.time > std::numbers::pi / oscillator.omega) break;
    EXPECT_NEAR(sample.position, 0.1 + 0.97 * std::cos(3.0 * sample.time), 2e-13);
  }
}

// The error must follow the tolerance: an 8th-order step whose error estimate is held at the
// tolerance gives a global error ∝ tolerance^(8/9) or better; three decades must gain two at least.
// A tolerance that is not passed on, or an event located at the ends of steps, fails here.
TEST(CoulombOscillator, ErrorFollowsTheTolerance) {
  const Oscillator oscillator;
  double previous = 0.0;
  for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
    const FrictionalMotion motion = oscillator.run(
        {.sample_interval = 8.0, .relative_tolerance = tolerance, .absolute_tolerance = 0.0}, 8.0);
    ASSERT_EQ(motion.events.size(), 5u);
    const double error = std::abs(motion.events.back().position + 0.07);
    std::printf("tolerance %.0e: error of the rest position %.2e m\n", tolerance, error);
    EXPECT_LE(error, 100.0 * tolerance);
    if (previous > 0.0) {
      EXPECT_LE(error, previous / 100.0);
    }
    previous = error;
  }
}

TEST(InclineOde, RefusesBadInput) {
  const FrictionalLoads good = incline_loads({.angle = 0.1, .friction = 0.5});
  const FrictionalOdeOptions options{.sample_interval = 0.1};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto run = [](const FrictionalLoads& loads, double v, double duration,
                      const FrictionalOdeOptions& o) {
    return integrate_frictional_motion(loads, {.velocity = v}, duration, o);
  };
  EXPECT_THROW(incline_loads({.angle = 0.1, .friction = -0.5}), std::invalid_argument);
  EXPECT_THROW(run({}, 1.0, 1.0, options), std::invalid_argument);
  EXPECT_THROW(run(good, nan, 1.0, options), std::invalid_argument);
  EXPECT_THROW(run(good, 1.0, 0.0, options), std::invalid_argument);
  EXPECT_THROW(run(good, 1.0, 1.0, {}), std::invalid_argument);
  EXPECT_THROW(run(good, 1.0, 1.0, {.sample_interval = 0.1, .relative_tolerance = -1.0}),
               std::invalid_argument);
  FrictionalLoads bad = good;
  bad.friction = -0.1;
  EXPECT_THROW(run(bad, 1.0, 1.0, options), std::invalid_argument);
  bad = good;
  bad.breakpoints = {nan};
  EXPECT_THROW(run(bad, 1.0, 1.0, options), std::invalid_argument);
}

// Failures inside GSL's C code must come out as exceptions, in slip, in stick and in a root search.
TEST(InclineOde, FailuresOfALoadComeOut) {
  const FrictionalOdeOptions options{.sample_interval = 0.1};
  FrictionalLoads loads = incline_loads({.angle = 0.1, .friction = 0.5});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  loads.tangential = over_time([nan](double t) { return t > 0.25 ? nan : 0.0; });
  EXPECT_THROW(integrate_frictional_motion(loads, {}, 1.0, options), std::runtime_error);
  EXPECT_THROW(integrate_frictional_motion(loads, {.velocity = 9.0}, 1.0, options),
               std::runtime_error);
  loads.tangential = over_time([](double t) {
    if (t > 0.22 && t < 0.28) throw std::domain_error("no load here");
    return t < 0.25 ? 0.0 : 50.0;
  });
  EXPECT_THROW(integrate_frictional_motion(loads, {}, 1.0, options), std::domain_error);
  EXPECT_THROW(integrate_frictional_motion(loads, {.velocity = 9.0}, 1.0, options),
               std::domain_error);
}

TEST(InclineOde, StopsAtTheMaximumOfEvents) {
  EXPECT_THROW(Oscillator().run({.sample_interval = 0.1, .maximum_events = 3}, 8.0),
               std::runtime_error);
}

}  // namespace
}  // namespace stiction::reference
