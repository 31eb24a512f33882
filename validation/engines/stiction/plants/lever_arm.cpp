// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: 2 % of a contact's reaction act on another partner, which moves its lever arm.
#include "solver/depth/depth.h"

namespace stiction {

void unplanted_depths(const Scene& scene, const Options& options, const State& state,
                      Workspace& workspace);

void depths(const Scene& scene, const Options& options, const State& state, Workspace& workspace) {
  unplanted_depths(scene, options, state, workspace);
  for (PairContact& contact : workspace.pairs) {
    contact.weight[0] += 0.02;
    contact.weight[1] -= 0.02;
  }
}

}  // namespace stiction
