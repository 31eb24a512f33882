// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace stiction::reference {

/// A block (a point mass) on a plane inclined by θ, under gravity g and Coulomb friction μ.
/// Positions and velocities along the slope count downhill. Every function below throws
/// std::invalid_argument unless 0 ≤ θ < π/2, μ ≥ 0 and g > 0 are all finite. Level ground is θ = 0.
struct Incline {
  double angle = 0.0;     ///< θ, rad
  double friction = 0.0;  ///< μ, dimensionless
  double gravity = 9.81;  ///< g, m/s²
};

/// tan θ_c = μ: the largest tangent (dimensionless) of a slope on which a block at rest stays at
/// rest. Throws std::invalid_argument for a negative or non-finite μ.
double critical_tangent(double friction);

/// Whether a block at rest stays at rest: tan θ ≤ μ, the two being equal when they differ by no
/// more than the rounding of θ and of its tangent.
bool sticks(const Incline& incline);

/// a = g (sin θ − μ cos θ), m/s², of a block that slides downhill: positive above the critical
/// slope, exactly zero at it (equality as in `sticks`), negative below.
double sliding_acceleration(const Incline& incline);

/// −a = g (μ cos θ − sin θ), m/s². Throws std::invalid_argument if the slope is critical or
/// steeper, since a sliding block then never stops.
double deceleration(const Incline& incline);

/// d = v₀²/(2g (μ cos θ − sin θ)), m, and t = v₀/(g (μ cos θ − sin θ)), s, from a downhill speed
/// v₀ ≥ 0, m/s, to rest. Both throw as `deceleration` does, and for a negative or non-finite v₀.
double stopping_distance(const Incline& incline, double speed);
double stopping_time(const Incline& incline, double speed);

/// How a point mass that symplectic Euler brakes comes to rest.
struct DiscreteStop {
  std::int64_t steps = 0;  ///< N, steps until the velocity is zero
  double time = 0.0;       ///< N Δt, s
  double distance = 0.0;   ///< x_N − x_0, m
  /// v₀ is a whole multiple of aΔt to round-off. The distance does not depend on it, but a run in
  /// floating point may then take one step more, with a velocity of round-off size.
  bool whole_multiple = false;
};

/// Exact solution of v_{n+1} = v_n − aΔt while v_n > aΔt, else 0; x_{n+1} = x_n + Δt v_{n+1}.
/// `speed` v₀ ≥ 0, m/s; `deceleration` a > 0, m/s²; `time_step` Δt > 0, s. Throws
/// std::invalid_argument for other values, or where more than 2⁵³ steps were needed.
DiscreteStop discrete_stop(double speed, double deceleration, double time_step);

/// A point mass on a line.
struct PointState {
  double position = 0.0;  ///< m
  double velocity = 0.0;  ///< m/s
};

/// Exact solution of v_{n+1} = v_n + aΔt, x_{n+1} = x_n + Δt v_{n+1} after `steps` n ≥ 0 steps.
/// `acceleration` a, m/s², of either sign (nothing sticks here); `time_step` Δt > 0, s. Throws
/// std::invalid_argument for other values, non-finite ones included.
PointState discrete_slide(const PointState& initial, double acceleration, double time_step,
                          std::int64_t steps);

/// Free fall under symplectic Euler, heights counted upwards: `discrete_slide` with a = −g, g > 0.
PointState discrete_free_fall(const PointState& initial, double gravity, double time_step,
                              std::int64_t steps);

}  // namespace stiction::reference
