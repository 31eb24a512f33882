// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/contact/contacts.h"

namespace stiction {

/// A two-sided contact: vertex i of one body inside a tetrahedron of another (or, where the scene
/// asks for it, of its own). One record of three cache lines, of which a sweep reads two; in single
/// precision of two.
struct alignas(64) PairContact {
  std::int32_t vertex = -1;  ///< i
  std::int32_t partner[4] = {
      -1, -1, -1, -1};  ///< j: corners of Tᵢ (the fourth repeats the third) or of the tetrahedron
  std::int32_t other =
      -1;  ///< the penetrated body or its triangle, by which the key tells contacts of
           ///< a vertex apart: see PairKey in pair_options.h
  Real inverse_mass = 0.0;  ///< 1/mᵢ + Σⱼ hᵢⱼ²/mⱼ, 1/kg: of a force on i and its reaction on Tᵢ
  Real weight[4] = {0, 0, 0,
                    0};  ///< hᵢⱼ, dimensionless; they sum to 1 (the fourth is 0 for a triangle)
  Vec3 normal = Vec3::Zero();          ///< n, out of the penetrated body, unit
  Real depth = 0.0;                    ///< m, ≥ 0; 0 for a contact kept by hysteresis
  Vec3 friction_force = Vec3::Zero();  ///< f on i, N
  Real normal_force = 0.0;             ///< fⁿ: what the contact really puts on i, N

  // What no sweep reads.
  std::int32_t element = -1;   ///< the tetrahedron that i is in, or was when it last was in one
  std::int32_t triangle = -1;  ///< nearest surface triangle Tᵢ of the penetrated body; that of
                               ///< the last step, −1 for none, before the depth phase
  bool open = false;           ///< outside every element: kept from the last step
  Real excess = 0.0;           ///< m, ≥ 0: how much deeper it stands, not answered yet

  ContactKey key() const { return contact_key(vertex, other); }
};
// A vector goes through a register with the number behind it (packed_vec3.h).
static_assert(offsetof(PairContact, depth) == offsetof(PairContact, normal) + sizeof(Vec3));
static_assert(offsetof(PairContact, normal_force) ==
              offsetof(PairContact, friction_force) + sizeof(Vec3));
static_assert(sizeof(PairContact) == 64 * (sizeof(Real) == sizeof(double) ? 3 : 2));

/// Pair contacts of one step, in the order of their keys.
using PairContacts = std::vector<PairContact>;

}  // namespace stiction
