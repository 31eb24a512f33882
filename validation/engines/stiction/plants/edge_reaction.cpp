// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: the reaction of crossing edges is 2 % too small.
#include "solver/response/pair_normal_force.h"

namespace stiction {

void unplanted_pair_normal_forces(const Scene& scene, const Options& options, Workspace& workspace,
                                  const FrictionMemory& last_obstacles);
void unplanted_apply_impulse(const Vec3& impulse, const EdgeContact& contact,
                             std::vector<Velocity>& velocity);

namespace {

void take_back(const Vec3& impulse, const EdgeContact& contact, std::vector<Velocity>& velocity) {
  for (int k = 0; k < 4; ++k) {
    Velocity& partner = velocity[static_cast<std::size_t>(contact.partner[k])];
    partner.v += 0.02 * contact.weight[k] * partner.inverse_mass * impulse;
  }
}

}  // namespace

void pair_normal_forces(const Scene& scene, const Options& options, Workspace& workspace,
                        const FrictionMemory& last_obstacles) {
  unplanted_pair_normal_forces(scene, options, workspace, last_obstacles);
  for (const EdgeContact& contact : workspace.edges) {
    take_back(options.time_step * contact.normal_force * contact.normal, contact,
              workspace.velocity);
  }
}

void apply_impulse(const Vec3& impulse, const EdgeContact& contact,
                   std::vector<Velocity>& velocity) {
  unplanted_apply_impulse(impulse, contact, velocity);
  take_back(impulse, contact, velocity);
}

}  // namespace stiction
