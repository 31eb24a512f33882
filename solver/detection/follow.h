// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Predicts where the vertices come to in a step of dt (s) with these velocities, `search.predicted`, and
/// notes of each body how far it has moved since its lists were made (`moved`), whether that is too far for
/// them (`renewed`), and how long a way it has gone in this scene (`path`). Returns whether any is renewed.
bool follow(const Scene& scene, Real dt, const State& state, const std::vector<Velocity>& velocity,
            const Team* team, PairSearch& search);

}  // namespace stiction
