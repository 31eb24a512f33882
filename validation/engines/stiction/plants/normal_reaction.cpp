// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: the normal force's reaction on the partners is 2 % too small.
#include "solver/response/pair_normal_force.h"

namespace stiction {

void unplanted_pair_normal_forces(const Scene& scene, const Options& options, Workspace& workspace,
                                  const FrictionMemory& last_obstacles);
void unplanted_apply_normal_force(const Options& options, const PairContact& contact,
                                  std::vector<Velocity>& velocity);

namespace {

void take_back(const Options& options, const PairContact& contact,
               std::vector<Velocity>& velocity) {
  if (!options.pairs.post_correction) return;
  const Vec3 missing = 0.02 * options.time_step * contact.normal_force * contact.normal;
  for (int k = 0; k < 4; ++k) {
    Velocity& partner = velocity[static_cast<std::size_t>(contact.partner[k])];
    partner.v += contact.weight[k] * partner.inverse_mass * missing;
  }
}

}  // namespace

void pair_normal_forces(const Scene& scene, const Options& options, Workspace& workspace,
                        const FrictionMemory& last_obstacles) {
  unplanted_pair_normal_forces(scene, options, workspace, last_obstacles);
  if (!options.pairs.normals_first) return;
  for (const PairContact& contact : workspace.pairs) {
    take_back(options, contact, workspace.velocity);
  }
}

void apply_normal_force(const Options& options, const PairContact& contact,
                        std::vector<Velocity>& velocity) {
  unplanted_apply_normal_force(options, contact, velocity);
  take_back(options, contact, velocity);
}

}  // namespace stiction
