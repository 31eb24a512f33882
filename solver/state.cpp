// SPDX-License-Identifier: BSD-3-Clause
#include "solver/state.h"

#include "solver/hash.h"

namespace stiction {

namespace {

template <class Number>
void add(const std::vector<Number>& numbers, Fnv1a& hash) {
  hash.add(numbers.data(), numbers.size() * sizeof(Number));
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
  for (const Position& p : state.position) hash.add(p.x.data(), sizeof p.x);
  for (const Velocity& v : state.velocity) hash.add(v.v.data(), sizeof v.v);
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
    hash.add(&excess.depth, sizeof excess.depth);
  }
  return hash.value();
}

}  // namespace stiction
