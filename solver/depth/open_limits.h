// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/state.h"

namespace stiction {

/// How far a contact that has opened may stand from its face or edge and is kept, m.
struct OpenLimits {
  Real gap;     ///< above it
  Real border;  ///< beyond its border or end

  OpenLimits(const Scene& scene, const Options& options, const State& state)
      : gap(static_cast<Real>(
            options.pairs.hysteresis * options.time_step * options.time_step *
            scene.gravity.at(static_cast<double>(state.step) * options.time_step).norm())),
        border(options.pairs.border_margin * scene.topology.mean_edge) {}
};

}  // namespace stiction
