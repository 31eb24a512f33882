// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: the depths of one triangle point into the body.
#include "solver/depth/depth.h"

namespace stiction {

void unplanted_depths(const Scene& scene, const Options& options, const State& state,
                      Workspace& workspace);

void depths(const Scene& scene, const Options& options, const State& state, Workspace& workspace) {
  unplanted_depths(scene, options, state, workspace);
  PairContacts& pairs = workspace.pairs;
  for (PairContact& contact : pairs) {
    if (pairs.site_of(contact).triangle == pairs.site(0).triangle) contact.normal = -contact.normal;
  }
}

}  // namespace stiction
