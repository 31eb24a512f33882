// SPDX-License-Identifier: BSD-3-Clause
#include "solver/state.h"

#include <cmath>
#include <limits>
#include <type_traits>

#include "solver/hash.h"

namespace stiction {

namespace {

// Which bits a NaN has depends on the order of operands, which is the compiler's choice: it is one
// NaN here.
void add(Real number, Fnv1a& hash) {
  if (std::isnan(number)) number = std::numeric_limits<Real>::quiet_NaN();
  hash.add(&number, sizeof number);
}

void add(const Vec3& numbers, Fnv1a& hash) {
  for (const Real number : numbers) add(number, hash);
}

template <class Number>
void add(const std::vector<Number>& numbers, Fnv1a& hash) {
  if constexpr (std::is_integral_v<Number> || std::is_enum_v<Number>) {
    hash.add(numbers.data(), numbers.size() * sizeof(Number));
  } else {
    for (const Number& number : numbers) add(number, hash);
  }
}

}  // namespace

State initial_state(const Scene& scene) {
  State state;
  const auto count = static_cast<std::size_t>(scene.vertex_count());
  state.position.resize(count);
  state.velocity.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    state.position[k] = {scene.rest_position.col(column), 0.0};
    state.velocity[k] = {scene.initial_velocity.col(column), scene.inverse_mass[k]};
  }
  return state;
}

std::uint64_t hash_of(const State& state) {
  Fnv1a hash;
  hash.add(&state.step, sizeof state.step);
  for (const Position& p : state.position) add(p.x, hash);
  for (const Velocity& v : state.velocity) add(v.v, hash);
  for (const FrictionMemory* memory :
       {&state.obstacle_friction, &state.pair_friction, &state.edge_friction}) {
    add(memory->key, hash);
    add(memory->status, hash);
    add(memory->value, hash);
  }
  add(state.pair_geometry.body_key, hash);
  add(state.pair_geometry.element, hash);
  add(state.pair_geometry.triangle, hash);
  for (const PairGeometry::Excess& excess : state.pair_geometry.excess) {
    hash.add(&excess.body_key, sizeof excess.body_key);
    add(excess.depth, hash);
  }
  return hash.value();
}

}  // namespace stiction
