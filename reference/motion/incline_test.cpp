// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/motion/incline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <tuple>

#include "reference/motion/test_rounding.h"

namespace stiction::reference {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The recurrence itself, the brute-force twin of `discrete_stop`.
DiscreteStop loop_stop(double speed, double deceleration, double time_step) {
  const double decrement = deceleration * time_step;
  DiscreteStop stop;
  for (double v = speed; v > 0.0;) {
    v = v > decrement ? v - decrement : 0.0;
    stop.distance += time_step * v;
    ++stop.steps;
  }
  stop.time = static_cast<double>(stop.steps) * time_step;
  return stop;
}

TEST(Incline, SticksUpToAndAtTheCriticalTangent) {
  for (double mu = 0.0; mu < 3.0; mu += 0.01) {
    const double critical = std::atan(critical_tangent(mu));
    const Incline at{.angle = critical, .friction = mu};
    EXPECT_TRUE(sticks(at)) << "μ = " << mu;
    EXPECT_EQ(sliding_acceleration(at), 0.0) << "μ = " << mu;
    // One part in 1e12 is far outside the rounding of θ (a few 1e-16), and must count.
    EXPECT_FALSE(sticks({.angle = critical + 1e-12, .friction = mu})) << "μ = " << mu;
    if (mu > 0.0) {
      EXPECT_TRUE(sticks({.angle = critical - 1e-12, .friction = mu}));
      EXPECT_LT(sliding_acceleration({.angle = critical - 1e-12, .friction = mu}), 0.0);
    }
  }
}

// Expected (analytic): 3-4-5 slope, sin θ = 0.6, cos θ = 0.8. Tolerance: five roundings (θ, tan,
// cos, difference, product) of the larger of the two terms that cancel; 4 times that, relative,
// below.
TEST(Incline, ClosedFormsOnAThreeFourFiveSlope) {
  const double angle = std::atan2(3.0, 4.0);
  const Incline above{.angle = angle, .friction = 0.5, .gravity = 10.0};
  EXPECT_NEAR(sliding_acceleration(above), 2.0, 5.0 * kEpsilon * 6.0);  // 6 − 4
  const Incline below{.angle = angle, .friction = 1.0, .gravity = 10.0};
  EXPECT_NEAR(deceleration(below), 2.0, 5.0 * kEpsilon * 8.0);  // 8 − 6
  EXPECT_NEAR(stopping_distance(below, 3.0), 2.25, 2.25 * 20.0 * kEpsilon);
  EXPECT_NEAR(stopping_time(below, 3.0), 1.5, 1.5 * 20.0 * kEpsilon);
}

TEST(Incline, LevelGroundIsAngleZero) {
  const Incline level{.friction = 0.5, .gravity = 8.0};
  EXPECT_EQ(stopping_distance(level, 2.0), 0.5);  // v₀²/(2μg), exact in binary
  EXPECT_EQ(stopping_time(level, 2.0), 0.5);      // v₀/(μg)
  EXPECT_EQ(stopping_distance(level, 0.0), 0.0);
}

TEST(Incline, RefusesWhatHasNoAnswer) {
  const Incline good{.angle = 0.1, .friction = 0.5};
  EXPECT_THROW(critical_tangent(-0.1), std::invalid_argument);
  EXPECT_THROW(critical_tangent(kNaN), std::invalid_argument);
  EXPECT_THROW(sticks({.angle = 0.1, .friction = kInfinity}), std::invalid_argument);
  EXPECT_THROW(sticks({.angle = -0.1, .friction = 0.5}), std::invalid_argument);
  EXPECT_THROW(sticks({.angle = kNaN, .friction = 0.5}), std::invalid_argument);
  EXPECT_THROW(sticks({.angle = 1.6, .friction = 0.5}), std::invalid_argument);
  EXPECT_THROW(sliding_acceleration({.friction = 0.5, .gravity = 0.0}), std::invalid_argument);
  EXPECT_THROW(stopping_distance(good, -1.0), std::invalid_argument);
  EXPECT_THROW(stopping_distance(good, kNaN), std::invalid_argument);
  EXPECT_THROW(stopping_distance({.angle = 0.6, .friction = 0.5}, 1.0), std::invalid_argument);
  EXPECT_THROW(stopping_time({.angle = std::atan(0.5), .friction = 0.5}, 1.0),
               std::invalid_argument);
  EXPECT_THROW(discrete_stop(1.0, 0.0, 0.1), std::invalid_argument);
  EXPECT_THROW(discrete_stop(1.0, -1.0, 0.1), std::invalid_argument);
  EXPECT_THROW(discrete_stop(1.0, 1.0, 0.0), std::invalid_argument);
  EXPECT_THROW(discrete_stop(kInfinity, 1.0, 0.1), std::invalid_argument);
  EXPECT_THROW(discrete_stop(1.0, 1e-300, 1e-300), std::invalid_argument);  // aΔt underflows
  EXPECT_THROW(discrete_slide({}, 1.0, 0.1, -1), std::invalid_argument);
  EXPECT_THROW(discrete_slide({.position = kNaN}, 1.0, 0.1, 1), std::invalid_argument);
  EXPECT_THROW(discrete_free_fall({}, -9.81, 0.1, 1), std::invalid_argument);
}

// All numbers below are dyadic, so that the loop is exact and nothing may differ.
TEST(DiscreteStop, EqualsTheLoopExactlyInBinaryNumbers) {
  for (int sixteenths = 0; sixteenths <= 200; ++sixteenths) {
    const double speed = sixteenths / 16.0;
    const DiscreteStop closed = discrete_stop(speed, 2.0, 0.125);  // aΔt = 1/4
    const DiscreteStop loop = loop_stop(speed, 2.0, 0.125);
    EXPECT_EQ(closed.steps, loop.steps) << speed;
    EXPECT_EQ(closed.distance, loop.distance) << speed;
    EXPECT_EQ(closed.time, loop.time) << speed;
    EXPECT_EQ(closed.whole_multiple, sixteenths % 4 == 0) << speed;
  }
}

// The loop subtracts N times with an error of v₀ε/2 each, so that v is good to N v₀ε/2 and the
// N-fold sum to N² Δt v₀ε/2, against d ≈ N Δt v₀/2: a relative N ε, doubled for the sum's own.
// The step count may be wrong by one only where that error, in units of aΔt, reaches a whole q.
TEST(DiscreteStop, EqualsTheLoopForRandomNumbers) {
  std::mt19937_64 random(20090115);
  std::uniform_real_distribution<double> exponent(-3.0, 1.0);
  for (int sample = 0; sample < 500; ++sample) {
    const double speed = std::pow(10.0, exponent(random));
    const double brake = std::pow(10.0, exponent(random));
    const double time_step = 1e-2 * std::pow(10.0, exponent(random));
    const DiscreteStop closed = discrete_stop(speed, brake, time_step);
    const DiscreteStop loop = loop_stop(speed, brake, time_step);
    const double n = static_cast<double>(closed.steps);
    EXPECT_LE(std::abs(closed.distance - loop.distance),
              2.0 * n * kEpsilon * (closed.distance + time_step * speed));
    const double q = speed / (brake * time_step);
    const bool ambiguous = std::abs(q - std::round(q)) <= n * q * kEpsilon;
    if (!ambiguous) {
      EXPECT_EQ(closed.steps, loop.steps) << "q = " << q;
    }
  }
}

// Whole multiples as decimals; in doubles 0.33/(3 · 0.01) = 11.000000000000002 and 3.5/(0.7 · 0.01)
// = 500.00000000000006, whose ceilings are one too many.
TEST(DiscreteStop, DecimalMultiplesCountAsWhole) {
  for (const auto& [speed, brake, time_step, steps] : {std::tuple{0.9, 3.0, 0.1, 3},
                                                       {1.0, 0.1, 1.0, 10},
                                                       {0.33, 3.0, 0.01, 11},
                                                       {3.5, 0.7, 0.01, 500},
                                                       {4.905, 9.81, 0.001, 500}}) {
    const DiscreteStop stop = discrete_stop(speed, brake, time_step);
    EXPECT_EQ(stop.steps, steps);
    EXPECT_TRUE(stop.whole_multiple);
    // At a multiple d = aΔt² N(N − 1)/2; five roundings of the inputs and of the formula.
    const double expected = brake * time_step * time_step * steps * (steps - 1) / 2.0;
    EXPECT_NEAR(stop.distance, expected, 5.0 * kEpsilon * expected);
  }
}

// d − v₀²/(2a) = −v₀Δt/2 + aΔt² f(1 − f)/2 with f = N − q. Tolerance: cancellation against the
// continuous distance, ten roundings of it.
TEST(DiscreteStop, FallsShortOfTheContinuousDistanceByHalfAStep) {
  const double brake = 1.7;
  for (double time_step = 0.1; time_step > 1e-5; time_step *= 0.37) {
    const double continuous = 2.3 * 2.3 / (2.0 * brake);
    const DiscreteStop stop = discrete_stop(2.3, brake, time_step);
    const double f = static_cast<double>(stop.steps) - 2.3 / (brake * time_step);
    const double bias =
        -2.3 * time_step / 2.0 + brake * time_step * time_step * f * (1.0 - f) / 2.0;
    EXPECT_NEAR(stop.distance - continuous, bias, 10.0 * kEpsilon * continuous);
    EXPECT_GE(stop.distance - continuous + 2.3 * time_step / 2.0, -10.0 * kEpsilon * continuous);
  }
}

// Round-off of the loop: n additions of at most ε/2 of the running value each, for v; x adds as
// many of a v that is already off. Relative to the largest values: n ε and 2 n ε.
TEST(DiscreteSlide, EqualsTheLoop) {
  for (const double acceleration : {-0.7, 0.0, 1.3}) {
    PointState loop{.position = 0.2, .velocity = 1.9};
    const double time_step = 0.003;
    for (int n = 0; n <= 2000; ++n) {
      const PointState closed = discrete_slide({0.2, 1.9}, acceleration, time_step, n);
      ASSERT_NEAR(closed.velocity, loop.velocity, (n + 4) * kEpsilon * 10.0) << n;
      ASSERT_NEAR(closed.position, loop.position, 2.0 * (n + 4) * kEpsilon * 40.0) << n;
      loop.velocity += acceleration * time_step;
      loop.position += time_step * loop.velocity;
    }
  }
}

TEST(DiscreteSlide, FreeFallIsExactInBinaryNumbers) {
  PointState loop{.position = 4.0, .velocity = 0.5};
  for (int n = 0; n <= 64; ++n) {
    const PointState closed = discrete_free_fall({4.0, 0.5}, 8.0, 0.0625, n);
    EXPECT_EQ(closed.velocity, loop.velocity) << n;
    EXPECT_EQ(closed.position, loop.position) << n;
    loop.velocity -= 0.5;
    loop.position += 0.0625 * loop.velocity;
  }
}

// A braked slide is a slide until its last moving step: the two closed forms must agree there.
// Tolerance: five roundings of each form.
TEST(DiscreteSlide, AgreesWithTheStopUpToItsLastMovingStep) {
  const DiscreteStop stop = discrete_stop(1.0, 3.0, 0.01);
  const PointState last = discrete_slide({0.0, 1.0}, -3.0, 0.01, stop.steps - 1);
  EXPECT_GT(last.velocity, 0.0);
  EXPECT_LE(last.velocity, 3.0 * 0.01);
  EXPECT_NEAR(last.position, stop.distance, 10.0 * kEpsilon * stop.distance);
}

}  // namespace
}  // namespace stiction::reference
