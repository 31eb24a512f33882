// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/workspace.h"

namespace stiction {

/// Brings `workspace.pair_order` up to date with the contacts between bodies and, while their records are at
/// hand, writes `workspace.load`: per vertex, how many contacts share it (dimensionless), which is what
/// their normal forces are divided by (pair_normal_force.h).
///
///   paper     Σⱼ hⱼₚ, over the contacts of which p is a partner
///   harmonic  N_p = (contacts whose vertex is p) + Σᵢ hᵢₚ, contacts with obstacles included
///
/// Those kept by hysteresis count in the paper's, and in N_p with `count_hysteresis`.
/// `last_obstacles`: the contacts with obstacles of the last step, of which those that have just
/// opened count on in N_p.
void contact_loads(const Scene& scene, const Options& options, const FrictionMemory& last_obstacles,
                   Workspace& workspace);

}  // namespace stiction
