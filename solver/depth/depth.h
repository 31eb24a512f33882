// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Depth, normal, nearest triangle, weights and inverse mass of each pair contact, at the predicted
/// positions; drops the kept contacts whose gap has become too wide and those that nothing can
/// move, and sets the keys as `options.pairs.key` says. Precondition: the partners of each contact
/// are the corners of its element, as detection leaves them.
///
///   d = x̂ − x*,  x̂ the point of the surface nearest to x*       (projection)
///
/// The normal is that of the triangle where x̂ lies inside it, else the direction of d. Weights:
/// those of x̂ in the triangle at the predicted positions, or of x_t0 in the tetrahedron at the
/// start-of-step positions (see PairWeights).
void depths(const Scene& scene, const Options& options, const State& state, Workspace& workspace);

/// A body is taken to be passed when something is deeper in it than this share of the least element
/// of the two.
inline constexpr Real kPassed = 0.4;

/// Notes in `too_deep` the first contact that deep (m) of a vertex, or an edge's end, in a body.
void note_too_deep(const Topology& topology, std::int32_t vertex, std::int32_t body, Real depth,
                   PairSearch::TooDeep& too_deep);

}  // namespace stiction
