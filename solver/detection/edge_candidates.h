// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/scene/scene.h"
#include "solver/workspace.h"

namespace stiction {

/// Lists the pairs of sharp edges of different bodies that can come to cross while the lists of
/// pair_candidates.h hold: those whose reference boxes, widened by 2s each, meet. Sweep and prune
/// along x over the edges within their bodies' overlaps; bodies that touch by faces and vertices
/// alone have none.
void find_edge_candidates(const Scene& scene, PairSearch& search);

}  // namespace stiction
