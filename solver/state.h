// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "solver/contact/contacts.h"
#include "solver/scene/scene.h"

namespace stiction {

/// Records of four numbers, 32 bytes in double precision: one contact update reads a vertex's
/// velocity and inverse mass from half a cache line, and a record goes through a register whole. The
/// inverse mass is constant and stands here as a copy of `Scene::inverse_mass`.
struct alignas(4 * sizeof(Real)) Velocity {
  Vec3 v;             ///< m/s
  Real inverse_mass;  ///< 1/kg
};
struct alignas(4 * sizeof(Real)) Position {
  Vec3 x;  ///< m
  Real unused;
};
struct alignas(4 * sizeof(Real)) Force {
  Vec3 f = Vec3::Zero();  ///< N
  Real unused = 0.0;
};
static_assert(sizeof(Velocity) == 4 * sizeof(Real) && sizeof(Position) == 4 * sizeof(Real) &&
              sizeof(Force) == 4 * sizeof(Real));

/// What persists of a pair contact besides its friction: where it was, for hysteresis and ties. In
/// the order of the body keys, which is that of `State::pair_friction` too.
struct PairGeometry {
  std::vector<ContactKey> body_key;  ///< (vertex, penetrated body)
  std::vector<std::int32_t> element;
  std::vector<std::int32_t> triangle;

  /// What of a depth is not answered yet (PairSite::excess), of the few contacts that have such.
  struct Excess {
    ContactKey body_key;
    Real depth;  ///< m, > 0
  };
  std::vector<Excess> excess;  ///< in the order of the keys

  /// What remember_pairs has written has a number of its own in the process, which copies share, so
  /// that lists of contacts know it again. 0: of anyone else.
  std::uint64_t serial = 0;
};

/// Everything that a step changes and the next step reads: what is hashed, saved and restored. A
/// copy of a State is a snapshot; assigning it back restores it, friction memory included.
struct State {
  std::uint64_t step = 0;            ///< steps done; time is t = step · Δt
  std::vector<Position> position;    ///< per vertex
  std::vector<Velocity> velocity;    ///< per vertex
  FrictionMemory obstacle_friction;  ///< of the obstacle contacts of the last step
  FrictionMemory pair_friction;      ///< of the pair contacts of the last step
  FrictionMemory edge_friction;      ///< of the edge contacts of the last step
  PairGeometry pair_geometry;
};

/// The scene's initial state.
State initial_state(const Scene& scene);

/// FNV-1a over step count, positions, velocities, friction memory and where pair contacts were, 64
/// bits. Equal states have equal hashes, any NaN as one; golden hashes hold per toolchain only.
std::uint64_t hash_of(const State& state);

}  // namespace stiction
