// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/contact/contacts.h"

namespace stiction {

/// A contact of two sharp edges that cross: what neither body's vertices see. Like a PairContact
/// whose vertex i is a point of an edge: edge a of one body, edge b of the other, a's body being
/// the one of the lower number.
struct EdgeContact {
  ContactKey key = 0;                 ///< (edge a, edge b), numbers in Topology::sharp_edge
  std::int32_t vertex[2] = {-1, -1};  ///< ends of edge a
  std::int32_t partner[4] = {-1, -1, -1, -1};  ///< corners of `element`
  std::int32_t element = -1;                   ///< a tetrahedron of b's body that has edge b
  Real own_weight[2] = {0, 0};                 ///< of the ends at the crossing; they sum to 1
  Real weight[4] = {0, 0, 0, 0};  ///< of a's crossing point in it at the start of the step; sum 1
  Vec3 normal = Vec3::Zero();     ///< across both edges, out of b's body, unit
  Real depth = 0.0;               ///< m, ≥ 0; 0 for a contact kept by hysteresis
  Vec3 friction_force = Vec3::Zero();  ///< f on edge a, N
  Real normal_force = 0.0;             ///< fⁿ on edge a, N
  Real inverse_mass = 0.0;             ///< Σ own_weight²/m + Σ weight²/m, 1/kg
};

static_assert(offsetof(EdgeContact, depth) == offsetof(EdgeContact, normal) + sizeof(Vec3));
static_assert(offsetof(EdgeContact, normal_force) ==
              offsetof(EdgeContact, friction_force) + sizeof(Vec3));

/// Edge contacts of one step, in the order of their keys.
using EdgeContacts = std::vector<EdgeContact>;

}  // namespace stiction
