// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: the depths of one triangle point into the body.
#include "solver/depth/depth.h"

namespace stiction {

void unplanted_depths(const Scene& scene, const Options& options, const State& state,
                      Workspace& workspace);

void depths(const Scene& scene, const Options& options, const State& state, Workspace& workspace) {
  unplanted_depths(scene, options, state, workspace);
  for (PairContact& contact : workspace.pairs) {
    if (contact.triangle == workspace.pairs.front().triangle) contact.normal = -contact.normal;
  }
}

}  // namespace stiction
