// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: between bodies, friction's reaction on the partners is 2 % too small.
#include "solver/friction/friction.h"

namespace stiction {

void unplanted_friction_forces(const Scene& scene, const Options& options, State& state,
                               Workspace& workspace);

void friction_forces(const Scene& scene, const Options& options, State& state,
                     Workspace& workspace) {
  unplanted_friction_forces(scene, options, state, workspace);
  if (!options.pairs.friction_reaction) return;
  for (const PairContact& contact : workspace.pairs) {
    const Vec3 missing = 0.02 * options.time_step * contact.friction_force;
    for (int k = 0; k < 4; ++k) {
      Velocity& partner = workspace.velocity[static_cast<std::size_t>(contact.partner[k])];
      partner.v += contact.weight[k] * partner.inverse_mass * missing;
    }
  }
}

}  // namespace stiction
