// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: between bodies, what friction remembers is renewed only in steps that change the
// contacts.
#include "solver/friction/friction.h"

namespace stiction {

void unplanted_friction_forces(const Scene& scene, const Options& options, State& state,
                               Workspace& workspace);

void friction_forces(const Scene& scene, const Options& options, State& state,
                     Workspace& workspace) {
  FrictionMemory last = state.pair_friction;
  unplanted_friction_forces(scene, options, state, workspace);
  if (state.pair_friction.key == last.key) state.pair_friction = std::move(last);
}

}  // namespace stiction
