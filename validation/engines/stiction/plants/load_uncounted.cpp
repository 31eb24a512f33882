// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: contacts that share a vertex are not counted: [Lazarevych2009, (5)] deleted,
// c = 1; with the harmonic gain every load is 1.
#include "solver/response/contact_load.h"

namespace stiction {

void contact_loads(const Scene& scene, const Options& options, const FrictionMemory&,
                   Workspace& workspace) {
  const auto vertices = static_cast<std::size_t>(scene.vertex_count());
  workspace.pair_order.make(workspace.pairs, scene.topology.vertex_place);
  workspace.load.assign(vertices, options.pairs.gain == NormalGain::kHarmonic ? 1.0 : 0.0);
}

}  // namespace stiction
