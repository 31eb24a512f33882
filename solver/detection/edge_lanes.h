// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "solver/contact/edge_contacts.h"
#include "solver/detection/edge_pair.h"
#include "solver/lanes/lanes.h"

namespace stiction {

/// Pairs of sharp edges, and how they pass each other.
struct EdgeBatch {
  int count = 0;
  std::int32_t a[kMostLanes], b[kMostLanes];
  EdgeCrossing crossing[kMostLanes];                ///< of those that can touch, here and below
  Real length_a[kMostLanes], length_b[kMostLanes];  ///< m
};

/// Which pairs of a batch, one at least, can touch as they lie (`crossing_of`) and cross no farther
/// beyond an end than `beyond`, m: a bit each. One at a time it would be the same to the bit. Positions
/// `x` per vertex, m; `width`: of registers, in doubles (lane_width.h).
unsigned cross_side_by_side(const Topology& topology, const std::vector<Vec3>& x, Real beyond,
                            int width, EdgeBatch& batch);

/// The corners of the tetrahedron that has edge b, the weights in it of the crossing at the start of the
/// step, and the inverse mass, of contacts whose edges and `own_weight` are known.
void set_partners(const Scene& scene, const State& state, const std::vector<Velocity>& velocity,
                  int width, std::span<EdgeContact> contacts);

}  // namespace stiction
