// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/state.h"

namespace stiction {

/// How far a contact that has opened may stand from its face or edge and is kept, m.
///
///   gap = min(hysteresis · |g|Δt · max(20 Δt, T), mean edge / 100),  T the scene's swing time
///
/// A contact that comes or goes changes the harmonic gain of those beside it, and so the velocity, by
/// up to the load's share of gΔt; an elastic body swings by that times T, however short the step is.
/// With 20 Δt alone the offset clamp of Fig. 3 rests at Δt = 0.2 ms and not at half of it, where one
/// vertex touches and leaves every 42 steps; it takes more than 20 Δt there and 60 Δt at a quarter,
/// and T is 122 and 245 Δt. Half of T and twice T do as well. T is of the whole scene, as Δt is: a slow
/// body widens the gaps of the others. Where nothing weighs, whatever presses, no gap is kept; and
/// slender bodies bend more slowly than a wave passes them.
struct OpenLimits {
  Real gap;     ///< above it
  Real border;  ///< beyond its border or end

  OpenLimits(const Scene& scene, const Options& options, const State& state)
      : gap(static_cast<Real>(gap_of(scene, options, state))),
        border(options.pairs.border_margin * scene.topology.mean_edge) {}

 private:
  static double gap_of(const Scene& scene, const Options& options, const State& state) {
    constexpr double kSteps = 20.0;   // of the penalty itself, where bodies are stiff or points
    constexpr double kWidest = 1e-2;  // in mean edges: what stands farther apart does not touch
    const double dt = options.time_step;
    const double gravity = scene.gravity.at(static_cast<double>(state.step) * dt).norm();
    const double speed = static_cast<double>(options.pairs.hysteresis) * gravity * dt;
    const double most = kWidest * static_cast<double>(scene.topology.mean_edge);
    return speed > 0.0 ? std::min(speed * std::max(kSteps * dt, scene.swing_time), most) : 0.0;
  }
};

}  // namespace stiction
