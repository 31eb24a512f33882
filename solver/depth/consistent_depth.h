// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/contact/pair_options.h"
#include "solver/scene/scene.h"
#include "solver/workspace.h"

namespace stiction {

/// ε over the penetrated body's longest edge at rest, dimensionless: detection takes a vertex in up
/// to 1e-12 of an element's altitude outside it; four times that leaves room for edges stretched
/// since rest. Far above the rounding of a height, 1e-15. (In single precision 2e-6, and 1e-7.)
inline constexpr Real kConsistentThin = by_precision(4e-12, 8e-6);

/// Replaces depth and normal of the penetrating contacts by consistent ones [Heidelberger2004], the
/// paper's sec. 3.2:
///
///   border vertices   d = Σ w (x_e − p)·n_e / Σ w,  n ∥ Σ w n_e,  w = 1/(|x_e − p|² + ε²)
///                     over the edges of p that leave the penetrated body, at x_e with normal n_e
///   inner vertices    breadth-first from those: d = Σ μ ((p_j − p)·n_j + d_j) / Σ μ,  n ∥ Σ μ n_j,
///                     μ = 1/|p_j − p|², over the neighbours p_j of lower levels
///
/// Edges are those of p's tetrahedra, the ones inside its own body included: a vertex in the middle
/// of a flat face has no other that leaves a body into which the face is pressed.
///
/// Deviations:
///  1. ε = kConsistentThin of the penetrated body's longest edge, where Heidelberger et al. have 0.
///     So a vertex on the surface itself takes the mean of what its edges leave through there instead
///     of 0/0, whatever side of it rounding puts the vertex on. Farther than 1e-4 edges from the
///     surface it changes w by less than rounding does.
///  2. An edge leaves where it first does, wherever it ends: one that comes back in counts too.
///     Theirs go from a colliding vertex to one that isn't; for convex bodies that is the same.
///  3. An edge leaves through a face only if it ends more than ε above it: one that lies in a face
///     doesn't leave through that.
///  4. Only surface vertices are in contact, so depths spread between those alone.
///  5. A negative depth is none. Where the normals cancel out there is no direction: the vertex
///     waits for its neighbours. What no level reaches keeps its projection: no edge of it leaves
///     (the whole body is inside), or it has none (a point mass).
void consistent_depths(const Scene& scene, const PairOptions& options, Workspace& workspace);

}  // namespace stiction
