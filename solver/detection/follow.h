// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Predicts where the vertices come to in a step of dt (s) with these velocities, `search.predicted`, and
/// notes of each body how far it has moved since its lists were made (`moved`), on how long a way
/// (`path`), and whether that is too far for them (`renewed`). Returns whether it is for any.
bool follow(const Scene& scene, Real dt, const State& state, const std::vector<Velocity>& velocity,
            const Team* team, PairSearch& search);

}  // namespace stiction
