// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/contact/pair_contacts.h"
#include "solver/depth/edge_walk.h"
#include "solver/depth/outlets.h"

namespace stiction {

/// Weighted means over what surrounds a vertex.
struct Average {
  Real weight = 0.0;
  Real depth = 0.0;            ///< times weights, m
  Vec3 normal = Vec3::Zero();  ///< times weights

  void add(Real w, Real d, const Vec3& n) {
    weight += w;
    depth += w * d;
    normal += w * n;
  }
  /// False if there is none, or no direction.
  bool write_to(PairContact& contact) const;
};

/// Over the edges that leave the body (consistent_depth.h), each of which is walked along.
Average average_by_walks(const Border& border, WalkScratch& scratch);

/// The same to the bit, where these are its outlets: several edges side by side in registers of `width`
/// doubles are asked through which of them they leave. Walked along is only what comes within some ε of the
/// border or the plane of one, seems to leave through two, or through one of another element than the vertex's
/// own though it may end in the body.
Average average_by_outlets(const Border& border, const Outlets& outlets, int width,
                           WalkScratch& scratch);

}  // namespace stiction
