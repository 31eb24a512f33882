// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Whether edges are looked at at all: the paper's gain knows no contacts of theirs.
bool with_edges(const Options& options);

/// How two edges pass each other.
struct EdgeCrossing {
  Real along_a, along_b;  ///< where, 0 … 1 from the first end
  Vec3 normal;            ///< n ∥ (direction of a) × (direction of b), out of b's body, unit
  Real gap;               ///< (point of a − point of b)·n, m; negative when they interpenetrate
};

/// Whether two sharp edges can touch as they lie, and how. They can if a plane across both has each
/// body's two faces there on its own side, as far as surfaces that bend allow: the arcs of the
/// edges' normals cross (a face of the Minkowski difference). Edges less than 5° from parallel
/// don't. Positions `x` per vertex, m.
bool crossing_of(const Topology& topology, const std::vector<Vec3>& x, std::int32_t a,
                 std::int32_t b, EdgeCrossing& crossing);

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
