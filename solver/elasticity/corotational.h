// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/elasticity/element_shares.h"
#include "solver/parallel/team.h"
#include "solver/scene/scene.h"
#include "solver/state.h"

namespace stiction {

/// Adds elastic and viscous forces of linear tetrahedra, N.
///
///   F = [x₁−x₀ …] Dₘ⁻¹ = R S                                     deformation gradient
///   P = R (2μ(S − I) + λ tr(S − I) I) + β F (2μĖ + λ tr(Ė) I)     first Piola–Kirchhoff stress, Pa
///   Ė = sym(FᵀḞ)                                                  Green strain rate, 1/s
///   [f₁ f₂ f₃] = −V P Dₘ⁻ᵀ,   f₀ = −f₁ − f₂ − f₃
///
/// Corotational linear elasticity [Mueller2004] with the exact energy gradient. The damping is
/// stiffness-proportional (Rayleigh's βK) in the limit of small strain; written with the Green
/// strain rate it is zero for every rigid motion, keeps angular momentum to round-off (P Fᵀ is
/// symmetric) and never creates energy (β · 2μ|Ė|² + λ tr² ≥ 0).
void add_corotational_forces(const Scene& scene, const State& state, std::vector<Force>& force);

/// At one of `lane_widths`: the same forces to the bit.
void add_corotational_forces(const Scene& scene, const State& state, std::vector<Force>& force,
                             int width);

/// By the team, in ranges that it leaves in `shares`: the same forces to the bit.
void add_corotational_forces(const Scene& scene, const State& state, const Team& team,
                             ElementShares& shares, std::vector<Force>& force);

/// Elastic energy Σ V (μ|S − I|² + ½λ tr²(S − I)), J.
double elastic_energy(const Scene& scene, const std::vector<Position>& position);

}  // namespace stiction
