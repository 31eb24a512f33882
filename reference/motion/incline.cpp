// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/motion/incline.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace stiction::reference {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

void check_speed(double speed) {
  if (!(speed >= 0.0) || !std::isfinite(speed)) {
    throw std::invalid_argument("The initial speed must be finite and not negative.");
  }
}

void check_time_step(double time_step) {
  if (!(time_step > 0.0) || !std::isfinite(time_step)) {
    throw std::invalid_argument("The time step must be finite and positive.");
  }
}

void check_gravity(double gravity) {
  if (!(gravity > 0.0) || !std::isfinite(gravity)) {
    throw std::invalid_argument("Gravity must be finite and positive.");
  }
}

// tan θ − μ, and exactly zero where rounding leaves no difference: θ rounded by ε/2 moves tan θ by
// θ (1 + tan² θ) ε/2, tan is good to one unit, and μ itself is rounded by ε/2. Twice their sum.
double tangent_excess(const Incline& incline) {
  if (!(incline.angle >= 0.0) || !(incline.angle < std::numbers::pi / 2.0)) {
    throw std::invalid_argument("The slope angle must lie in [0, π/2) radians.");
  }
  check_gravity(incline.gravity);
  const double tangent = std::tan(incline.angle);
  const double critical = critical_tangent(incline.friction);
  const double rounding =
      kEpsilon * (incline.angle * (1.0 + tangent * tangent) + 2.0 * tangent + critical);
  return std::abs(tangent - critical) <= rounding ? 0.0 : tangent - critical;
}

}  // namespace

// tan θ_c = μ
double critical_tangent(double friction) {
  if (!(friction >= 0.0) || !std::isfinite(friction)) {
    throw std::invalid_argument("The friction coefficient must be finite and not negative.");
  }
  return friction;
}

// tan θ ≤ μ
bool sticks(const Incline& incline) { return tangent_excess(incline) <= 0.0; }

// a = g (sin θ − μ cos θ) = g cos θ (tan θ − μ)
double sliding_acceleration(const Incline& incline) {
  const double excess = tangent_excess(incline);
  return incline.gravity * std::cos(incline.angle) * excess;
}

// −a = g (μ cos θ − sin θ)
double deceleration(const Incline& incline) {
  const double value = -sliding_acceleration(incline);
  if (!(value > 0.0)) {
    throw std::invalid_argument(
        "The block never stops: the slope is at or above the critical one, tan θ ≥ μ.");
  }
  return value;
}

// d = v₀²/(2 |a|)
double stopping_distance(const Incline& incline, double speed) {
  check_speed(speed);
  return speed * speed / (2.0 * deceleration(incline));
}

// t = v₀/|a|
double stopping_time(const Incline& incline, double speed) {
  check_speed(speed);
  return speed / deceleration(incline);
}

// v_k = v₀ − k aΔt > 0 for k < q = v₀/(aΔt), so N = ⌈q⌉ and
//   d = Δt Σ_{k=1}^{N−1} (v₀ − k aΔt) = Δt (N − 1)(v₀ − aΔt N/2).
// With f = N − q this is v₀²/(2a) − v₀Δt/2 + aΔt² f(1 − f)/2: symplectic Euler falls short of the
// continuous distance by v₀Δt/2, less at most aΔt²/8. d is continuous where q is whole, so the
// rounding of q can change N but not d.
// Limits: v₀ ≤ aΔt stops within the first step and does not move at all; v₀ = 0 takes no step.
DiscreteStop discrete_stop(double speed, double deceleration, double time_step) {
  check_speed(speed);
  check_time_step(time_step);
  if (!(deceleration > 0.0) || !std::isfinite(deceleration)) {
    throw std::invalid_argument("The deceleration must be finite and positive.");
  }
  const double decrement = deceleration * time_step;
  const double quotient = speed / decrement;
  if (!(quotient <= 0x1p53)) {
    throw std::invalid_argument("The block needs more than 2^53 steps to stop.");
  }
  // v₀, a, Δt, their product and the quotient are each rounded by ε/2: 2.5 ε, taken as 3 ε.
  const double nearest = std::round(quotient);
  const bool whole = std::abs(quotient - nearest) <= 3.0 * kEpsilon * quotient;
  const double steps = whole ? nearest : std::ceil(quotient);
  DiscreteStop stop;
  stop.steps = static_cast<std::int64_t>(steps);
  stop.time = steps * time_step;
  if (steps > 1.0) stop.distance = time_step * (steps - 1.0) * (speed - 0.5 * steps * decrement);
  stop.whole_multiple = whole;
  return stop;
}

// v_n = v₀ + n aΔt,  x_n = x₀ + nΔt v₀ + aΔt² n(n + 1)/2 = x₀ + nΔt (v₀ + aΔt (n + 1)/2)
PointState discrete_slide(const PointState& initial, double acceleration, double time_step,
                          std::int64_t steps) {
  check_time_step(time_step);
  if (!std::isfinite(initial.position) || !std::isfinite(initial.velocity) ||
      !std::isfinite(acceleration)) {
    throw std::invalid_argument("The initial state and the acceleration must be finite.");
  }
  if (steps < 0) throw std::invalid_argument("The number of steps must not be negative.");
  const double n = static_cast<double>(steps);
  const double increment = acceleration * time_step;
  return {initial.position + n * time_step * (initial.velocity + 0.5 * (n + 1.0) * increment),
          initial.velocity + n * increment};
}

// a = −g
PointState discrete_free_fall(const PointState& initial, double gravity, double time_step,
                              std::int64_t steps) {
  check_gravity(gravity);
  return discrete_slide(initial, -gravity, time_step, steps);
}

}  // namespace stiction::reference
