// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/engine.h"

namespace stiction {

/// What the pipes cost, beside a step of the engine with a body at rest on level ground.
struct ProtocolCost {
  double request = 0.0;      ///< wall-clock of an empty `advance` and its answer, s
  double request_cpu = 0.0;  ///< … CPU time of the engine's process: what its cost counts too much
  double observation =
      0.0;  ///< wall-clock of a step and of the body's motion after it, less the step, s
  double step_cpu = 0.0;  ///< CPU time of a step, s
};

/// Medians of some thousand requests. Throws InputError for what the engine does.
ProtocolCost protocol_cost(const EngineKind& kind, const Settings& settings);

}  // namespace stiction
