// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/parallel/team.h"
#include "solver/scene/scene.h"
#include "solver/state.h"

namespace stiction {

/// Fᵢ = mᵢ g(t), N; `force` gets the scene's vertex count. Pinned vertices get a force too; it
/// moves nothing.
void gravity_forces(const Scene& scene, double time, std::vector<Force>& force,
                    const Team* team = nullptr);

/// Adds −mᵢ c(t) vᵢ, N, while there is drag.
void add_drag_forces(const Scene& scene, double time, const std::vector<Velocity>& velocity,
                     std::vector<Force>& force);

/// v* = v_t0 + Δt F/m, per vertex; 1/m = 0 where pinned.
void predict(Real dt, const std::vector<Force>& force, const std::vector<Velocity>& velocity_t0,
             std::vector<Velocity>& predicted, const Team* team = nullptr);

/// Gives the pinned vertices of bodies with a motion the mean velocity of that motion over the step
/// that starts at `time`, s.
void follow_motions(const Scene& scene, double time, double dt, std::vector<Velocity>& predicted);

}  // namespace stiction
