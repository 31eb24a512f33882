// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/scene/scene.h"
#include "solver/workspace.h"

namespace stiction {

/// Lists the pairs of sharp edges of different bodies that can come to cross while the lists of
/// pair_candidates.h hold: those whose reference boxes, widened by 2s each, meet. To be called when
/// those lists were made anew, or `edges_listed` is false; in the first case the pairs of two bodies
/// that have not moved keep what is known of them.
void find_edge_candidates(const Scene& scene, PairSearch& search);

}  // namespace stiction
