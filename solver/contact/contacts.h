// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "solver/scene/scene.h"

namespace stiction {

// Glossary and signs, once for the whole suite.
//
//   gap                  signed distance of a vertex from the obstacle, m; negative inside.
//   penetration depth    d = max(0, −gap) at the predicted position, m [Lazarevych2009, (2)].
//   normal n             unit, out of the penetrated body or obstacle, towards the vertex.
//   normal force fⁿ      magnitude ≥ 0, N; acts on the vertex along +n (Signorini: it never pulls).
//   free slip ũ          tangential slip velocity that the step would end with if this contact had
//                        no friction, m/s; start slip u: the same at the start of the step.
//   inverse mass w       velocity change of the pair per unit friction force held for a step:
//                        w = Δt (1/mᵢ + Σⱼ hᵢⱼ²/mⱼ), m/s/N [(9)–(11)]; a fixed obstacle adds
//                        nothing.
//   friction force f     tangential, acts on the vertex, N; |f| ≤ μ fⁿ (Coulomb's cone).
//   stick, slip          a contact sticks when its friction ends the slip within the step, else it
//                        slips and f = −μ fⁿ ũ/|ũ|.
//   friction memory      what a rule keeps per contact from step to step (ξ and the like).
//
// State ends: _t0 start of the step, _t1 its end.

enum class ContactStatus : std::uint8_t { kNew, kStick, kSlip };

/// Identity of a contact from step to step, two numbers ≥ 0: (obstacle, vertex); between bodies
/// (vertex, body) or (vertex, triangle), see PairKey; of crossing edges (edge a, edge b). Contacts
/// stand in the order of their keys.
using ContactKey = std::uint64_t;

constexpr ContactKey contact_key(std::int32_t first, std::int32_t second) {
  return static_cast<ContactKey>(static_cast<std::uint32_t>(first)) << 32 |
         static_cast<std::uint32_t>(second);
}
constexpr std::int32_t first_of(ContactKey key) { return static_cast<std::int32_t>(key >> 32); }
constexpr std::int32_t second_of(ContactKey key) {
  return static_cast<std::int32_t>(key & 0xffffffffu);
}

/// Contacts of one step of vertices against fixed obstacles: one-sided, no partner to push back.
/// Structure of arrays; every array has `size()` entries.
struct OneSidedContacts {
  std::vector<ContactKey> key;
  std::vector<std::int32_t> vertex;
  std::vector<std::int32_t> obstacle;
  std::vector<Real> depth;              ///< at the predicted position, m
  std::vector<Vec3> obstacle_velocity;  ///< mean over the step, m/s
  std::vector<Real> normal_force;       ///< fⁿ, N
  std::vector<Vec3> friction_force;     ///< f on the vertex, N

  /// Scratch of detection: what the ranges of vertices have found that threads look at.
  struct Found {
    std::int32_t vertex;
    Real depth;  ///< m
  };
  std::vector<std::vector<Found>> found;

  std::size_t size() const { return key.size(); }
  void clear() { resize(0); }
  void resize(std::size_t count);
  /// The c-th is this one, without forces yet.
  void set(std::size_t c, ContactKey contact, std::int32_t vertex_number,
           std::int32_t obstacle_number, Real penetration_depth, const Vec3& velocity_of_obstacle);
  void add(ContactKey contact, std::int32_t vertex_number, std::int32_t obstacle_number,
           Real penetration_depth, const Vec3& velocity_of_obstacle = Vec3::Zero());
};

/// Friction memory of the contacts of one step, in the order of their keys: part of the state.
struct FrictionMemory {
  std::vector<ContactKey> key;
  std::vector<ContactStatus> status;  ///< at the end of the step
  std::vector<Real> value;            ///< values per contact × contact count, rule's own units
};

}  // namespace stiction
