// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/workspace.h"

namespace stiction {

/// Normal force of each pair contact from its depth, N.
///
///   paper     F = (mᵢ/Δt²) γᵢ dᵢ,  γᵢ = Mᵢ/(cᵢ mᵢ + Mᵢ),  Mᵢ = Σⱼ cⱼ hᵢⱼ mⱼ,  cᵢ = 1/(1 + Σⱼ hⱼᵢ)
///             [Lazarevych2009, (3)–(5)], of which the post-correction transmits a half
///   harmonic  fⁿ = κ₀ dᵢ/Δt² / (Nᵢ/mᵢ + Σⱼ hᵢⱼ Nⱼ/mⱼ),
///             N_p = (contacts whose vertex is p) + Σᵢ hᵢₚ, contacts kept by hysteresis included
///
/// A contact of p with an obstacle counts in N_p as well: else a corner that lies on the floor and
/// bears another body closes both depths whole, and is thrown to and fro between them for ever
/// (seen in a basket of 112 objects: one vertex at 2 cm/s, in steps of opposite sign). One of the
/// last step that has just opened counts on: else a light one that comes and goes every other step
/// moves the gains of its neighbours to and fro (seen in a basket: 1 cm/s for ever).
///
/// The harmonic gain bounds what a step closes of any combination of depths by κ₀, and a pinned j
/// drops out (1/m = 0). In the paper's gain a pinned vertex is the limit m → ∞: one pinned j makes
/// γᵢ = 1; a pinned i leaves F = Mᵢ dᵢ/(cᵢ Δt²).
///
/// With `normals_first` they are applied too; else the friction sweep applies each (friction.h).
/// `last_obstacles`: the contacts with obstacles of the last step.
void pair_normal_forces(const Scene& scene, const Options& options, Workspace& workspace,
                        const FrictionMemory& last_obstacles = {});

/// Applies the normal force of one contact to the velocities: with the post-correction [(6)] half
/// of F to the vertex and −hᵢⱼ times that half to its partners; without it all of F to the vertex
/// alone. The harmonic force is what is transmitted, and needs no halving.
void apply_normal_force(const Options& options, const PairContact& contact,
                        std::vector<Velocity>& velocity);

}  // namespace stiction
