// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The phase itself, for a way to look up μ. Each way has a source of its own: two in one source, and GCC
// no longer inlines what a contact needs (1.45 times the instructions, GCC 12); one way that asks at each
// contact whether there is a table takes 1.07 times as many.

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "solver/demand.h"
#include "solver/friction/chunks_of_side.h"
#include "solver/friction/conjugate_directions.h"
#include "solver/friction/friction.h"
#include "solver/friction/sides.h"
#include "solver/friction/with_rule.h"
#include "solver/response/pair_normal_force.h"

namespace stiction::friction_phase {

// Whether two lists of keys are the same, as in most steps.
inline bool same_keys(const std::vector<ContactKey>& a, const std::vector<ContactKey>& b,
                      const Team* team) {
  if (a.size() != b.size()) return false;
  std::atomic<bool> same = true;
  for_ranges(team, a.size(), kContactsToShare, [&](std::size_t begin, std::size_t end) {
    if (!std::equal(a.data() + begin, a.data() + end, b.data() + begin)) same = false;
  });
  return same;
}

// Moves the memory of the contacts that persist to their new places, both lists being in the order
// of their keys, and resets it for the others. What `old` has then is of no use.
template <class Rule>
void carry_memory(const Rule& rule, const std::vector<ContactKey>& keys, const Team* team,
                  FrictionMemory& old, FrictionMemory& memory) {
  constexpr auto kValues = static_cast<std::size_t>(Rule::kValues);
  const std::size_t count = keys.size();
  const bool fits = STICTION_HAS_FRICTION_MEMORY && old.value.size() == old.key.size() * kValues;
  if (fits && same_keys(keys, old.key, team)) {
    std::swap(old, memory);
    return;
  }
  memory.key = keys;
  memory.status.resize(count);
  memory.value.resize(count * kValues);
  std::size_t from = 0;
  for (std::size_t c = 0; c < count; ++c) {
    while (from < old.key.size() && old.key[from] < keys[c]) ++from;
    const bool persists = fits && from < old.key.size() && old.key[from] == keys[c];
    Real* const value = memory.value.data() + c * kValues;
    if (persists) {
      memory.status[c] = old.status[from];
      std::copy_n(old.value.data() + from * kValues, kValues, value);
    } else {
      memory.status[c] = ContactStatus::kNew;
      rule.reset(value);
    }
  }
}

template <class Rule, class Side>
void warm_start(const Rule& rule, const Side& side, const FrictionMemory& memory, const Team* team,
                std::span<Velocity> velocity) {
  using Vector = typename Side::Vector;
  const auto of_chunk = [&](std::size_t, const ContactOrder::Chunk& chunk)
      __attribute__((always_inline)) {
    const Side here = side;
    const Real* const value = memory.value.data();
    const std::span<Velocity> velocities = velocity;
    const auto [begin, end] = chunk;
    for (std::size_t place = begin; place < end; ++place) {
      here.ask_ahead(place, velocities);
      const std::size_t c = here.contact(place);
      Vector force = Vector::Zero();
      if constexpr (Rule::kWarmStart) {
        const Real* const own = value + c * static_cast<std::size_t>(Rule::kValues);
        force = tangential(Vector(rule.start(own)), here.normal(c));
        const Real bound = here.bound(c);
        const Real size2 = force.squaredNorm();
        if (size2 > bound * bound) force *= bound / std::sqrt(size2);
        auto held = here.held(c, velocities);
        here.push(force, held);
      }
      here.set_force(c, force);
    }
  };
  for_each_chunk(side, team, of_chunk);
}

// Whether a rule reckons in vectors of this kind.
template <class Rule, class Vector>
concept Takes = requires(const Rule& rule, const SlipProblemOf<Vector>& problem, Real* memory) {
  { rule.solve(problem, memory) } -> std::same_as<SlipSolutionOf<Vector>>;
};

// One contact of a sweep; `first` is true in the first sweep of a step, `was` its status at the
// start of the step, `is` that at its end. Returns the change of its force, N.
template <class Rule, class Side>
STICTION_LANES_INLINE typename Side::Vector solve(const Rule& rule, const Side& side, std::size_t c,
                                                  bool first, ContactStatus was,
                                                  std::span<const Velocity> start,
                                                  std::span<Velocity> velocity, ContactStatus& is,
                                                  Real* memory) {
  using Vector = typename Side::Vector;
  using Reckoned = std::conditional_t<Takes<Rule, Vector>, Vector, Vec3>;
  auto held = side.held(c, velocity);
  const Vector force = side.force(c);
  const Real inverse_mass = side.inverse_mass(c, velocity);
  const SlipProblemOf<Reckoned> problem{
      .free_slip = vector_cast<Reckoned>(held.slip() - inverse_mass * force),
      .start_slip = vector_cast<Reckoned>(side.slip(c, start)),
      .inverse_mass = inverse_mass,
      .bound = side.bound(c),
      .was = was,
      .normal = vector_cast<Reckoned>(side.normal(c)),
      .first_sweep = first,
      .force = vector_cast<Reckoned>(force)};
  const SlipSolutionOf<Reckoned> solution = rule.solve(problem, memory);
  const Vector solved = solution.force, change = solved - force;
  side.push(change, held);
  side.set_force(c, solved);
  is = solution.status;
  return change;
}

// Hears of the changes of a sweep, chunk by chunk: see ConjugateSide.
struct Unheard {
  static void start(std::size_t) {}
  template <class Vector>
  static void add(std::size_t, const Vector&) {}
  static void finish(std::size_t, const ContactOrder::Chunk&) {}
};

// A sweep over contacts of one kind, of whose changes `heard` hears.
template <class Rule, class Side, class Before, class Heard>
void sweep(const Rule& rule, const Side& side, bool first, FrictionMemory& memory,
           std::vector<ContactStatus>& ended, const Team* team, std::span<const Velocity> start,
           std::span<Velocity> velocity, const Before& before, Heard& heard) {
  const auto of_chunk = [&](std::size_t k, const ContactOrder::Chunk& chunk)
      __attribute__((always_inline)) {
    // Copies, of which the compiler knows that nothing else changes them.
    const Side here = side;
    Heard hears = heard;
    Real* const value = memory.value.data();
    const ContactStatus* const was = memory.status.data();
    ContactStatus* const is = ended.data();
    const Rule own_rule = rule;
    const Before own_before = before;
    const std::span<const Velocity> at_start = start;
    const std::span<Velocity> velocities = velocity;
    const bool is_first = first;
    const auto [begin, end] = chunk;
    hears.start(k);
    for (std::size_t place = begin; place < end; ++place) {
      here.ask_ahead(place, velocities);
      const std::size_t c = here.contact(place);
      own_before(c);
      Real* const own = value + c * static_cast<std::size_t>(Rule::kValues);
      hears.add(c, solve(own_rule, here, c, is_first, was[c], at_start, velocities, is[c], own));
    }
    hears.finish(k, chunk);
  };
  for_each_chunk(side, team, of_chunk);
}

template <class Rule>
constexpr bool is_conjugate() {
  if constexpr (requires { Rule::kConjugate; }) {
    return Rule::kConjugate;
  } else {
    return false;
  }
}

// What a step leaves for the next.
inline void remember(FrictionMemory& memory, std::vector<ContactStatus>& ended,
                     FrictionMemory& of_state) {
  std::swap(memory.status, ended);
  std::swap(of_state, memory);
}

template <class Friction>
void run(const Friction& mu, const Scene& scene, const Options& options, State& state,
         Workspace& workspace) {
  std::vector<Velocity>& velocity = workspace.velocity;
  const Team* const team = workspace.team;
  workspace.obstacle_order.make(workspace.contacts);
  if (!workspace.pair_order.is_for(workspace.pairs.size())) {
    workspace.pair_order.make(workspace.pairs, scene.topology.vertex_place);
  }
  assert(workspace.pair_order.is_of(workspace.pairs));
  if (!workspace.edge_order.is_for(workspace.edges.size())) {
    workspace.edge_order.make(workspace.edges, scene.topology.vertex_place);
  }
  assert(workspace.edge_order.is_of(workspace.edges));
  const ObstacleSide<Friction> obstacles{scene, mu, options.dt(), workspace.contacts,
                                         workspace.obstacle_order};
  const PairSide<Friction> pairs(options, mu, workspace.pairs, workspace.pair_order);
  const EdgeSide<Friction> edges(options.dt(), mu, workspace.edges, workspace.edge_order);
  workspace.ended.resize(obstacles.size());
  workspace.pair_ended.resize(pairs.size());
  workspace.edge_ended.resize(edges.size());
  const bool known = with_friction_rule(options.rule, options.friction, [&](const auto& rule) {
    carry_memory(rule, obstacles.keys(), team, state.obstacle_friction, workspace.memory);
    carry_memory(rule, pairs.keys(), team, state.pair_friction, workspace.pair_friction);
    carry_memory(rule, edges.keys(), team, state.edge_friction, workspace.edge_friction);
    warm_start(rule, pairs, workspace.pair_friction, team, velocity);
    warm_start(rule, edges, workspace.edge_friction, team, velocity);
    warm_start(rule, obstacles, workspace.memory, team, velocity);
    const auto nothing = [](std::size_t) {};
    const auto sweep_all = [&](bool first, auto& pairs_heard, auto& edges_heard,
                               auto& obstacles_heard) {
      const auto normal_force = [&](std::size_t c) {
        if (first && !options.pairs.normals_first) {
          apply_normal_force(options, workspace.pairs[c], velocity);
        }
      };
      sweep(rule, pairs, first, workspace.pair_friction, workspace.pair_ended, team, state.velocity,
            velocity, normal_force, pairs_heard);
      sweep(rule, edges, first, workspace.edge_friction, workspace.edge_ended, team, state.velocity,
            velocity, nothing, edges_heard);
      sweep(rule, obstacles, first, workspace.memory, workspace.ended, team, state.velocity,
            velocity, nothing, obstacles_heard);
    };
    const int sweeps = options.sweeps > 0 ? options.sweeps : rule.kCard.sweeps;
    if constexpr (is_conjugate<std::decay_t<decltype(rule)>>()) {
      const auto tolerance =
          static_cast<Real>(rule.slip_tolerance() * scene.gravity.scale() * options.time_step);
      ConjugateSide pair_side(pairs, workspace.pair_conjugate, team, velocity);
      ConjugateSide edge_side(edges, workspace.edge_conjugate, team, velocity);
      ConjugateSide obstacle_side(obstacles, workspace.conjugate, team, velocity);
      workspace.sweeps += static_cast<std::uint64_t>(
          conjugate_sweeps(sweeps, tolerance, sweep_all, pair_side, edge_side, obstacle_side));
    } else {
      Unheard unheard;
      for (int s = 0; s < sweeps; ++s) sweep_all(s == 0, unheard, unheard, unheard);
      workspace.sweeps += static_cast<std::uint64_t>(sweeps);
    }
  });
  demand(known, "the options were checked, so the friction rule exists");
  remember(workspace.memory, workspace.ended, state.obstacle_friction);
  remember(workspace.pair_friction, workspace.pair_ended, state.pair_friction);
  remember(workspace.edge_friction, workspace.edge_ended, state.edge_friction);
  workspace.contact_updates += obstacles.size() + pairs.size() + edges.size();
}

}  // namespace stiction::friction_phase
