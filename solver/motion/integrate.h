// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/parallel/team.h"
#include "solver/state.h"

namespace stiction {

/// x_t1 = x_t0 + Δt v_t1; the corrected velocities become the state's (the arrays are exchanged).
void integrate(Real dt, std::vector<Velocity>& corrected, State& state, const Team* team = nullptr);

}  // namespace stiction
