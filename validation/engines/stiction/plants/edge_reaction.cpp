// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: the reaction of crossing edges is 2 % too small.
#include "solver/friction/friction.h"

namespace stiction {

void unplanted_friction_forces(const Scene& scene, const Options& options, State& state,
                               Workspace& workspace);

void friction_forces(const Scene& scene, const Options& options, State& state,
                     Workspace& workspace) {
  unplanted_friction_forces(scene, options, state, workspace);
  for (const EdgeContact& contact : workspace.edges) {
    const Vec3 impulse =
        options.time_step * (contact.normal_force * contact.normal + contact.friction_force);
    for (int k = 0; k < 4; ++k) {
      Velocity& partner = workspace.velocity[static_cast<std::size_t>(contact.partner[k])];
      partner.v += 0.02 * contact.weight[k] * partner.inverse_mass * impulse;
    }
  }
}

}  // namespace stiction
