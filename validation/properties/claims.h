// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "validation/engine/engine.h"
#include "validation/properties/random_scene.h"

namespace stiction::test {

/// What became of a random scene.
struct Outcome {
  std::string broken{};        ///< the first claim that didn't hold, in words; empty: all did
  std::string refused{};       ///< what the engine said when it would not go on; empty: it did
  std::uint64_t contacts = 0;  ///< looked at
  double friction_work = 0.0;  ///< of all steps, J; its claim is that it is not above 0
};

/// Simulates it for `steps` and holds each step against what a configuration of the solver claims:
///
///   linear momentum   Σ m v changes by Δt times what acts from outside: gravity, drag, loads, and
///                     what contacts with half-spaces are told to do. Not for parts that are held;
///                     between bodies not for `old`, which leaves out reactions.
///   Coulomb's cone    |f| ≤ μ fⁿ
///   dissipation       f · u ≤ 0 for a vertex that touches a half-space alone, and where it slips
///                     f is against u; between bodies of the sum over all steps (contacts that are
///                     solved later in a sweep move those before) and those that slide, of `quiet`
///                     alone: contacts that stick have what slip its sweeps have left them, along f
///                     as well as against it
///   energy            of `quiet`: what there is beyond the work done from outside never exceeds
///                     what there was by more than the integrator's share
///   no silent passage of `quiet`: what an outside watch finds, the engine has refused
///   finite numbers    else it must refuse
Outcome outcome_of(const RandomScene& scene, const Settings& settings, int steps);

}  // namespace stiction::test
