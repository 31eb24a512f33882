// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Normal force of each contact, applied to the predicted velocities in place.
///
///   Fᵢ = (mᵢ/Δt²) γᵢ dᵢ,   γᵢ = Mᵢ/(cᵢ mᵢ + Mᵢ)            [Lazarevych2009, (3)–(5)]
///
/// Deviations:
/// 1. A fixed obstacle is the limit Mᵢ → ∞: γᵢ = 1, and the force is not halved by the
///    post-correction, which one-sided contacts do not need. The step ends with the vertex on the
///    plane: no rebound, no standing depth.
/// 2. dᵢ is what the contacts before this one in the order have left of the depth, so a vertex in
///    two obstacles at once is not pushed twice. Never negative: contacts do not pull.
///
/// Approaching kinetic energy is lost, none is created: with a gap ≥ 0 at _t0 the vertex ends with
/// 0 ≥ vₙ ≥ v*ₙ.
void normal_forces(const Scene& scene, double dt, const State& state, Workspace& workspace);

}  // namespace stiction
