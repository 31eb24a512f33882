// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "solver/scene/scene.h"

namespace stiction {

/// About how long a body takes to swing, s: its size, twice the distance of the farthest vertex from
/// the centre of mass, over the speed √(E/ρ) of a wave along a bar. It depends neither on the mesh
/// nor on how the body is turned. 0 of point masses.
/// `mass` is kg, of each vertex.
double swing_time(const BodyDescription& body, const std::vector<double>& mass);

}  // namespace stiction
