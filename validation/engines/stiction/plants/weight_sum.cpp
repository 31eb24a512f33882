// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: the weights of a contact's partners sum to 1.02.
#include "solver/depth/depth.h"

namespace stiction {

void unplanted_depths(const Scene& scene, const Options& options, const State& state,
                      Workspace& workspace);

void depths(const Scene& scene, const Options& options, const State& state, Workspace& workspace) {
  unplanted_depths(scene, options, state, workspace);
  for (PairContact& contact : workspace.pairs) contact.weight[0] += 0.02;
}

}  // namespace stiction
