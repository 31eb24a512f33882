// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/state.h"

namespace stiction {

/// How far a contact that has opened may stand from its face or edge and is kept, m.
struct OpenLimits {
  Real gap;     ///< above it
  Real border;  ///< beyond its border or end

  OpenLimits(const Scene& scene, const Options& options, const State& state)
      : gap(static_cast<Real>(gap_of(scene, options, state))),
        border(options.pairs.border_margin * scene.topology.mean_edge) {}

 private:
  static double gap_of(const Scene& scene, const Options& options, const State& state) {
    constexpr double kSteps = 20.0;   // in which bodies that don't swing come to rest
    constexpr double kWidest = 1e-2;  // in mean edges: what stands farther apart does not touch
    const double dt = options.time_step;
    const double gravity = scene.gravity.at(static_cast<double>(state.step) * dt).norm();
    const double speed = static_cast<double>(options.pairs.hysteresis) * gravity * dt;
    const double most = kWidest * static_cast<double>(scene.topology.mean_edge);
    return speed > 0.0 ? std::min(speed * std::max(kSteps * dt, scene.swing_time), most) : 0.0;
  }
};

}  // namespace stiction
