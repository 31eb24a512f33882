// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "solver/scene/scene.h"
#include "solver/state.h"

namespace stiction {

/// Adds what loads and springs do to the vertices of their bodies at this time, N. A force F gives
/// each vertex mᵢ/m F. A couple τ gives it mᵢ α × (xᵢ − c), with J α = τ and J the body's present
/// inertia about its centre c; no part of τ acts on a body that has none about its axis.
void add_load_forces(const Scene& scene, double time, const State& state,
                     std::vector<Force>& force);

}  // namespace stiction
