// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/depth/edge_walk.h"
#include "solver/depth/outlets.h"

namespace stiction {

/// Finds the outlets of a vertex, and by how much the paths of both bodies may grow, m, while there are
/// no others; 0 where that is not known. Few of them if that lasts for long as bodies move now: `stride` is
/// the longest way of a vertex in a step, m.
///
/// Let ends of edges move by up to a, corners of the body by up to b, and a + b = d. Let a point x of an edge
/// be in a tetrahedron afterwards, or above none of its faces by more than ε. With the least altitude H ≥ 60 d
/// of that tetrahedron its altitudes change by less than 4/60 + (4/60)² …, 8 %, and with H ≥ 600 ε as well the
/// barycentric coordinates λ of x have Σ |λ| ≤ 1 + 6 ε/H ≤ 1.01. So the point with the same coordinates before
/// was no more than 1.1 ε above any face, and within 1.01 b of x; the same point of the edge before was
/// within a of x, and so above none of the faces by more than
///
///   1.2 ε + 1.1 d
///
/// So it is with a point near a face. Hence what a walk of ε comes to afterwards, element by element, a walk as
/// wide as that comes to before, and all that `find_exit` then comes near is among what that meets.
///
/// Where an edge ends in none of the elements of the wide walk, no walk of ε ends in one afterwards: if it
/// crosses one of these triangles alone, that is where the walk leaves. A triangle of the vertex's own element is
/// where it leaves wherever it ends. Another one need not be, if it may end in the body: where that folds onto
/// itself the triangle may belong to another part of it.
Real find_outlets(const Border& border, Real stride, WalkScratch& scratch, Outlets& outlets);

}  // namespace stiction
