// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: friction pushes along the slip.
#include "solver/friction/friction.h"
#include "solver/response/pair_normal_force.h"

namespace stiction {

void unplanted_friction_forces(const Scene& scene, const Options& options, State& state,
                               Workspace& workspace);

void friction_forces(const Scene& scene, const Options& options, State& state,
                     Workspace& workspace) {
  unplanted_friction_forces(scene, options, state, workspace);
  // Taken back, and put on with the other sign.
  const double dt = options.time_step;
  const auto push = [&](std::int32_t vertex, double weight, const Vec3& impulse) {
    Velocity& velocity = workspace.velocity[static_cast<std::size_t>(vertex)];
    velocity.v += weight * velocity.inverse_mass * impulse;
  };
  OneSidedContacts& obstacles = workspace.contacts;
  for (std::size_t c = 0; c < obstacles.size(); ++c) {
    push(obstacles.vertex[c], 1.0, -2.0 * dt * obstacles.friction_force[c]);
    obstacles.friction_force[c] = -obstacles.friction_force[c];
  }
  for (PairContact& contact : workspace.pairs) {
    const Vec3 impulse = -2.0 * dt * contact.friction_force;
    push(contact.vertex, 1.0, impulse);
    for (int k = 0; options.pairs.friction_reaction && k < 4; ++k) {
      push(contact.partner[k], -contact.weight[k], impulse);
    }
    contact.friction_force = -contact.friction_force;
  }
  for (EdgeContact& contact : workspace.edges) {
    const Vec3 impulse = -2.0 * dt * contact.friction_force;
    for (int k = 0; k < 2; ++k) push(contact.vertex[k], contact.own_weight[k], impulse);
    for (int k = 0; k < 4; ++k) push(contact.partner[k], -contact.weight[k], impulse);
    contact.friction_force = -contact.friction_force;
  }
}

}  // namespace stiction
