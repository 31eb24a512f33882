// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/options.h"
#include "solver/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Friction of each contact by the chosen rule, applied to the velocities in place (Seidel order);
/// the friction memory moves on from the last step's contacts to this step's. A contact that is
/// new, because it did not exist in the last step, starts with the rule's fresh memory.
///
///   vᵢ ← vᵢ + Δt/mᵢ f,   |f| ≤ μ fⁿ                        [Lazarevych2009, (7)–(14)]
///
/// Deviation 1: fⁿ is the normal force that the contact really transmits. (With |Fᵢ| before the
/// post-correction's ½ a two-sided contact would stick up to 2μ.)
void friction_forces(const Scene& scene, const Options& options, State& state,
                     Workspace& workspace);

}  // namespace stiction
