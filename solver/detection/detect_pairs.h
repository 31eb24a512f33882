// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/detection/holding.h"
#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Finds the surface vertices whose predicted position x* = x_t0 + Δt v* lies in a tetrahedron of
/// another body (of its own, where the body asks for it), among the candidates of
/// pair_candidates.h; fills in key (vertex, body), vertex, site and, as partners, the element's corners
/// of `workspace.pairs`, one contact a vertex and penetrated body, in the order of their keys. With
/// hysteresis the contacts of the last step that have opened by less than the allowed gap are kept.
///
/// A vertex well inside the tetrahedron of the last step is still in it, and no other is tested.
/// Else a vertex on the face between tetrahedra belongs to the one that it is deepest in, the lower
/// number winning a tie.
void detect_pairs(const Scene& scene, const Options& options, const State& state,
                  Workspace& workspace);

/// Makes the corners of an element the contact's partners.
void set_corners(const std::vector<Element>& elements, std::int32_t element, PairContact& contact);

}  // namespace stiction
