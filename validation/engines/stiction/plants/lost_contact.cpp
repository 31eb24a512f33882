// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: one contact between bodies is lost every 100 steps.
#include "solver/detection/detect_pairs.h"

namespace stiction {

void unplanted_detect_pairs(const Scene& scene, const Options& options, const State& state,
                            Workspace& workspace);

void detect_pairs(const Scene& scene, const Options& options, const State& state,
                  Workspace& workspace) {
  unplanted_detect_pairs(scene, options, state, workspace);
  if (state.step % 100 == 99 && !workspace.pairs.empty())
    workspace.pairs.resize(workspace.pairs.size() - 1);
}

}  // namespace stiction
