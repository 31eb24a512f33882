// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: the paper's normal force is transmitted whole, without the ½ of
// [Lazarevych2009, (6)].
#include "solver/response/pair_normal_force.h"

namespace stiction {

void unplanted_pair_normal_forces(const Scene& scene, const Options& options, Workspace& workspace,
                                  const FrictionMemory& last_obstacles);

void pair_normal_forces(const Scene& scene, const Options& options, Workspace& workspace,
                        const FrictionMemory& last_obstacles) {
  unplanted_pair_normal_forces(scene, options, workspace, last_obstacles);
  if (options.pairs.gain != NormalGain::kPaper || !options.pairs.post_correction) return;
  for (PairContact& contact : workspace.pairs) {
    // The other half too, where the first has been applied.
    if (options.pairs.normals_first) apply_normal_force(options, contact, workspace.velocity);
    contact.normal_force *= 2.0;
  }
}

}  // namespace stiction
