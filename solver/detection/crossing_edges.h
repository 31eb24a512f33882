// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Whether edges are looked at at all: the paper's gain knows no contacts of theirs.
bool with_edges(const Options& options);

/// Fills `workspace.edges` with the crossings of the candidates at the predicted positions.
///
///   d = −gap,   weights: of a's point at the start of the step, on a and in a tetrahedron at b
///
/// A contact begins when edges interpenetrate by no more than a hundredth of a mean edge, or more
/// if they did not at the start of the step, between their ends and as far from corners (there a
/// vertex touches; else a body that slides over another's corner, pressed into it by a standing
/// depth, would be caught there). It ends `border_margin` beyond an edge, or at the gap allowed by
/// hysteresis. Of the crossings of one edge with one body that push in different directions the
/// shallowest counts.
void crossing_edges(const Scene& scene, const Options& options, const State& state,
                    Workspace& workspace);

}  // namespace stiction
