// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/scene.h"
#include "solver/workspace.h"

namespace stiction {

/// Replaces depth and normal of the penetrating contacts by consistent ones [Heidelberger2004]:
///
///   border vertices   d = Σ w (x_e − p)·n_e / Σ w,  n ∥ Σ w n_e,  w = 1/|x_e − p|²
///                     over the edges of p that cross the surface at x_e with normal n_e
///   inner vertices    breadth-first from those: d = Σ μ ((p_j − p)·n_j + d_j) / Σ μ,  n ∥ Σ μ n_j,
///                     μ = 1/|p_j − p|²
///
/// Deviations: crossings are sought among the triangles near the penetrated element; a contact that
/// no crossing edge leads to keeps its projection; a negative depth is none.
void consistent_depths(const Scene& scene, Workspace& workspace);

}  // namespace stiction
