// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "solver/mesh/topology.h"
#include "solver/real.h"

namespace stiction {

/// Around a surface triangle, for as long as lists hold.
struct TriangleBall {
  Vec3 centre;  ///< m
  Real radius;  ///< m
};

/// Balls about the centres of the triangles from `begin` on, below `end`, with their corners at `x`, m,
/// and `margin`, m, more. At one of `lane_widths`: the same bits at each.
void bound_triangles(const Topology& topology, std::size_t begin, std::size_t end,
                     const std::vector<Vec3>& x, Real margin, int width,
                     std::vector<TriangleBall>& ball);

}  // namespace stiction
