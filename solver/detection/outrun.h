// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/scene/scene.h"
#include "solver/workspace.h"

namespace stiction {

/// Notes in `search.outrun` the first two bodies that come at each other, or past each other, by
/// more in one step than the thinner one's least element is wide: a vertex could then be before a
/// body in one step and behind it in the next, and nothing would tell. To be asked whenever the
/// lists of candidates are made anew, which is every step where anything is that fast; the boxes
/// are those of the lists. Nothing is noted for bodies that stay apart, or slower.
void note_outrun(const Scene& scene, Real dt, const std::vector<Velocity>& velocity,
                 PairSearch& search);

}  // namespace stiction
