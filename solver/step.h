// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Advances `state` by one time step Δt: symplectic Euler with a contact predictor and corrector
/// [Lazarevych2009, sec. 3].
///
///   1  v* = v_t0 + Δt M⁻¹ F(x_t0, v_t0),   x* = x_t0 + Δt v*
///   2  contacts: vertices whose x* lies inside an obstacle or another body, edges that cross at x*;
///      their depths and normals
///   3  normal forces, then friction, on v* in place, contact by contact (Seidel)
///   4  x_t1 = x_t0 + Δt v_t1
///
/// Störmer–Verlet differs in the first step alone, whose forces act for Δt/2: from then on v is the
/// velocity half a step before x. (3) needs Δx = Δt² F/m, which holds for both.
///
/// The options must have passed `check_options` for this scene.
void step(const Scene& scene, const Options& options, State& state, Workspace& workspace);

/// One phase of it alone, for benchmarks: needs what the phases before it left in the workspace.
/// `state.step` is counted by `step`, which also leaves out the depth phase where no two bodies can
/// touch.
void run_phase(Phase phase, const Scene& scene, const Options& options, State& state,
               Workspace& workspace);

}  // namespace stiction
