// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"
#include "validation/engine/engine.h"

namespace stiction {

/// The solver's contacts of its last step as an outside evaluator sees them: vertices on obstacles,
/// then vertices in bodies, then crossing edges. `time_step` in s.
std::vector<ContactSample> contact_samples(const Scene& scene, const State& state,
                                           const Workspace& workspace, double time_step);

/// The body that a vertex belongs to, by its place in the scene.
std::size_t body_of(const Scene& scene, std::int32_t vertex);

}  // namespace stiction
