// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/walk_scratch.h"

namespace stiction {

void WalkScratch::begin(std::size_t elements, std::size_t triangles) {
  ++positions;
  triangle.resize(triangles);
  triangle_at.resize(triangles, 0);
  visited.resize(elements, 0);
  planes.resize(elements);
  planes_at.resize(elements, 0);
}

}  // namespace stiction
