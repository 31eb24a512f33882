// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "reference/motion/incline.h"

namespace stiction::reference {

/// A load divided by the mass, m/s², at time t (s), position x (m) and velocity v (m/s).
using AccelerationLoad = std::function<double(double t, double x, double v)>;

/// Loads on a point mass that moves along a line with Coulomb friction.
struct FrictionalLoads {
  AccelerationLoad tangential;      ///< a_t, all tangential forces but friction
  AccelerationLoad normal;          ///< a_n, the normal force; a negative value means separation
  double friction = 0.0;            ///< μ, dimensionless, static and kinetic
  std::vector<double> breakpoints;  ///< times at which a load jumps, s; in any order
};

/// The loads of a block on a slope: a_t = g sin θ, a_n = g cos θ. Throws as `sticks` does.
FrictionalLoads incline_loads(const Incline& incline);

/// Tolerances are those of one step, of x in m and of v in m/s.
struct FrictionalOdeOptions {
  double sample_interval = 0.0;       ///< s; also the longest step, in slip and in stick
  double relative_tolerance = 1e-13;  ///< dimensionless
  double absolute_tolerance = 1e-16;  ///< m and m/s
  std::size_t maximum_events = 10000;
};

enum class FrictionalEventKind {
  kStickToSlip,
  kSlipToStick,
  kReversal,  ///< the velocity passes through zero and slip goes on in the other direction
};

/// A change of the frictional state. The velocity at an event is zero.
struct FrictionalEvent {
  FrictionalEventKind kind = FrictionalEventKind::kSlipToStick;
  double time = 0.0;      ///< s
  double position = 0.0;  ///< m
};

/// One sample of the motion.
struct FrictionalSample {
  double time = 0.0;      ///< s
  double position = 0.0;  ///< m
  double velocity = 0.0;  ///< m/s
  bool sticking = false;
};

struct FrictionalMotion {
  std::vector<FrictionalSample> samples;  ///< at 0, each sample interval, and the duration itself
  std::vector<FrictionalEvent> events;    ///< by time
};

/// Integrates a mass with Coulomb friction from t = 0 over `duration` (s):
///   slip:  v̇ = a_t − μ a_n sign v,
///   stick: v = 0 while |a_t(t, x, 0)| ≤ μ a_n(t, x, 0), a few roundings above it included,
/// where a_n < 0 counts as zero. Slip steps are the Prince–Dormand 8(9) pair of GSL with error
/// control; zeros of v (interior double zeros of a step too) and the end of stick are located by
/// Brent's method to round-off. [GSL, PrinceDormand1981, Brent1973]
///
/// A load may depend on time in any smooth way; name its jumps as breakpoints, at which it is
/// evaluated from the left before and from the right after. What exceeds the stick bound for less
/// than a sample interval can be missed.
///
/// Throws std::invalid_argument for missing loads, a bad μ, state, duration, interval or tolerance;
/// std::runtime_error if a load is not finite, GSL cannot keep the tolerance, or the events exceed
/// their maximum; and whatever a load throws.
FrictionalMotion integrate_frictional_motion(const FrictionalLoads& loads,
                                             const PointState& initial, double duration,
                                             const FrictionalOdeOptions& options);

}  // namespace stiction::reference
