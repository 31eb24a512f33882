// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Friction of each contact by the chosen rule, applied to the velocities in place (Seidel order:
/// pairs, as normal forces have ordered them, crossing edges, obstacles); the friction memory moves
/// on from the last step's contacts to this step's. A contact that is new, because it did not exist in the last step, starts with fresh memory.
///
///   vᵢ ← vᵢ + Δt/mᵢ f,   vⱼ ← vⱼ − Δt/mⱼ hᵢⱼ f,   |f| ≤ μ fⁿ       [Lazarevych2009, (7)–(14)]
///
/// The friction force is distributed whole, not halved like the normal force [sec. 4.1].
///
/// Deviations:
/// 1. fⁿ is the normal force that the contact really transmits. (With |Fᵢ| before the
///    post-correction's ½ a two-sided contact would stick up to 2μ; `literal_bound` restores that.)
/// 2. With `normals_first` all normal forces have been applied before. Without it, as in the paper,
///    each pair's normal force is applied here, just before its friction.
/// 3. A rule that stores forces has them all applied first, projected on the tangent plane and
///    clamped (a warm start); then it iterates, `options.sweeps` times over all contacts.
void friction_forces(const Scene& scene, const Options& options, State& state,
                     Workspace& workspace);

/// The same where pairs have a μ of their own: friction_forces calls it.
void friction_forces_of_pairs(const Scene& scene, const Options& options, State& state,
                              Workspace& workspace);

}  // namespace stiction
