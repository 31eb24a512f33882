// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/depth/edge_walk.h"
#include "solver/depth/outlets.h"

namespace stiction {

/// Finds the outlets of a vertex, and by how much the paths of both bodies may grow, m, while there are
/// no others; 0 where that is not known. Few of them if that lasts for long as bodies move now: `stride` is
/// the longest way of a vertex in a step, m.
///
/// Let every end of an edge move by up to a, every corner of the body by up to b, and a + b = d. What is
/// within ε of an element then was, at the same barycentric coordinates, within 1.2 ε of the element before,
/// and no farther than b from where it is, if the element's least altitude is at least 60 d, so that it
/// keeps its shape to a tenth, and 600 ε. So a point of an edge that is within ε of an element, or of one of
/// its faces, was within
///
///   1.2 ε + 1.1 d
///
/// of that: all triangles that `find_exit` then comes near are met by a walk so wide along the edge as it
/// is now, by the same elements.
Real find_outlets(const Border& border, Real stride, WalkScratch& scratch, Outlets& outlets);

}  // namespace stiction
