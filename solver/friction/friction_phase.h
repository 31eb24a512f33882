// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The phase itself, for a way to look up μ. Each way has a source of its own: two in one source, and GCC
// no longer inlines what a contact needs (1.45 times the instructions, GCC 12); one way that asks at each
// contact whether there is a table takes 1.07 times as many.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <type_traits>
#include <utility>

#include "solver/contact/slip.h"
#include "solver/demand.h"
#include "solver/friction/catalog.h"
#include "solver/friction/conjugate_directions.h"
#include "solver/friction/friction.h"
#include "solver/response/pair_normal_force.h"

namespace stiction::friction_phase {

// The contacts with obstacles, as the sweep sees them.
template <class Friction>
struct ObstacleSide {
  const Scene& scene;
  Friction mu;
  Real dt;
  OneSidedContacts& contacts;
  const ContactOrder& order;

  std::size_t size() const { return contacts.size(); }
  ContactKey key(std::size_t c) const { return contacts.key[c]; }
  Vec3& force(std::size_t c) const { return contacts.friction_force[c]; }
  ContactStatus& status(std::size_t c) const { return contacts.status[c]; }
  const HalfSpace& obstacle(std::size_t c) const {
    return scene.half_spaces[static_cast<std::size_t>(contacts.obstacle[c])];
  }
  const Vec3& normal(std::size_t c) const { return obstacle(c).normal; }
  Real bound(std::size_t c) const {
    return mu.against(obstacle(c), contacts.vertex[c], contacts.obstacle[c]) *
           contacts.normal_force[c];
  }
  Real inverse_mass(std::size_t c, const std::vector<Velocity>& velocity) const {
    return dt * velocity[static_cast<std::size_t>(contacts.vertex[c])].inverse_mass;
  }
  Vec3 slip(std::size_t c, const std::vector<Velocity>& velocity) const {
    const Vec3& v = velocity[static_cast<std::size_t>(contacts.vertex[c])].v;
    return tangential(v - contacts.obstacle_velocity[c], normal(c));
  }
  void apply(std::size_t c, const Vec3& force, std::vector<Velocity>& velocity) const {
    Velocity& own = velocity[static_cast<std::size_t>(contacts.vertex[c])];
    own.v += dt * own.inverse_mass * force;
  }
};

// The contacts between bodies.
template <class Friction>
struct PairSide {
  const Options& options;
  Friction mu;
  PairContacts& pairs;
  const ContactOrder& order;

  std::size_t size() const { return pairs.size(); }
  ContactKey key(std::size_t c) const { return pairs[c].key; }
  Vec3& force(std::size_t c) const { return pairs[c].friction_force; }
  ContactStatus& status(std::size_t c) const { return pairs[c].status; }
  const Vec3& normal(std::size_t c) const { return pairs[c].normal; }
  Real bound(std::size_t c) const {
    const PairOptions& pair = options.pairs;
    const bool doubled =
        pair.literal_bound && pair.gain == NormalGain::kPaper && pair.post_correction;
    return mu.between(pairs[c].vertex, pairs[c].partner[0]) * (doubled ? 2 : 1) *
           pairs[c].normal_force;
  }
  Real inverse_mass(std::size_t c, const std::vector<Velocity>&) const {
    return options.dt() * pairs[c].inverse_mass;
  }
  Vec3 slip(std::size_t c, const std::vector<Velocity>& velocity) const {
    return slip_of(pairs[c], velocity);
  }
  void apply(std::size_t c, const Vec3& force, std::vector<Velocity>& velocity) const {
    const PairContact& contact = pairs[c];
    const Vec3 impulse = options.dt() * force;
    Velocity& own = velocity[static_cast<std::size_t>(contact.vertex)];
    own.v += own.inverse_mass * impulse;
    if (!options.pairs.friction_reaction) return;
    for (int k = 0; k < 4; ++k) {
      Velocity& other = velocity[static_cast<std::size_t>(contact.partner[k])];
      other.v -= contact.weight[k] * other.inverse_mass * impulse;
    }
  }
};

// The contacts of crossing edges.
template <class Friction>
struct EdgeSide {
  Real dt;
  Friction mu;
  EdgeContacts& edges;
  const ContactOrder& order;

  std::size_t size() const { return edges.size(); }
  ContactKey key(std::size_t c) const { return edges[c].key; }
  Vec3& force(std::size_t c) const { return edges[c].friction_force; }
  ContactStatus& status(std::size_t c) const { return edges[c].status; }
  const Vec3& normal(std::size_t c) const { return edges[c].normal; }
  Real bound(std::size_t c) const {
    return mu.between(edges[c].vertex[0], edges[c].partner[0]) * edges[c].normal_force;
  }
  Real inverse_mass(std::size_t c, const std::vector<Velocity>&) const {
    return dt * edges[c].inverse_mass;
  }
  Vec3 slip(std::size_t c, const std::vector<Velocity>& velocity) const {
    return slip_of(edges[c], velocity);
  }
  void apply(std::size_t c, const Vec3& force, std::vector<Velocity>& velocity) const {
    apply_impulse(dt * force, edges[c], velocity);
  }
};

// Moves the memory of the contacts that persist to their new places, both lists being in the order
// of their keys, and resets it for the others.
template <class Rule, class Side>
void carry_memory(const Rule& rule, const FrictionMemory& old, const Side& side, const Team* team,
                  FrictionMemory& memory) {
  constexpr auto kValues = static_cast<std::size_t>(Rule::kValues);
  const std::size_t count = side.size();
  memory.key.resize(count);
  if (STICTION_HAS_FRICTION_MEMORY && old.key.size() == count &&
      old.value.size() == count * kValues) {
    std::atomic<bool> same = true;  // as in most steps: all is carried as it is
    for_ranges(team, count, kContactsToShare, [&](std::size_t begin, std::size_t end) {
      bool same_here = true;
      for (std::size_t c = begin; c < end; ++c) {
        memory.key[c] = side.key(c);
        same_here = same_here && memory.key[c] == old.key[c];
      }
      if (!same_here) same = false;
    });
    if (same) {
      memory.status = old.status;
      memory.value = old.value;
      return;
    }
  }
  memory.status.resize(count);
  memory.value.resize(count * kValues);
  std::size_t from = 0;
  for (std::size_t c = 0; c < count; ++c) {
    memory.key[c] = side.key(c);
    while (from < old.key.size() && old.key[from] < memory.key[c]) ++from;
    const bool persists = STICTION_HAS_FRICTION_MEMORY && from < old.key.size() &&
                          old.key[from] == memory.key[c] &&
                          old.value.size() == old.key.size() * kValues;
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
                std::vector<Velocity>& velocity) {
  side.order.for_each_contact(team, [&](std::size_t c) {
    side.force(c) = Vec3::Zero();
    if constexpr (Rule::kWarmStart) {
      Vec3 force = tangential(rule.start(memory.value.data() + c * Rule::kValues), side.normal(c));
      const Real bound = side.bound(c);
      const Real size2 = force.squaredNorm();
      if (size2 > bound * bound) force *= bound / std::sqrt(size2);
      side.apply(c, force, velocity);
      side.force(c) = force;
    }
  });
}

// One contact of a sweep; `first` is true in the first sweep of a step, `was` its status at the
// start of the step. Returns the change of its force, N.
template <class Rule, class Side>
Vec3 solve(const Rule& rule, const Side& side, std::size_t c, bool first, ContactStatus was,
           const std::vector<Velocity>& start, std::vector<Velocity>& velocity, Real* memory) {
  const Real inverse_mass = side.inverse_mass(c, velocity);
  const SlipProblem problem{.free_slip = side.slip(c, velocity) - inverse_mass * side.force(c),
                            .start_slip = side.slip(c, start),
                            .inverse_mass = inverse_mass,
                            .bound = side.bound(c),
                            .was = was,
                            .normal = side.normal(c),
                            .first_sweep = first,
                            .force = side.force(c)};
  const SlipSolution solution = rule.solve(problem, memory);
  const Vec3 change = solution.force - side.force(c);
  side.apply(c, change, velocity);
  side.force(c) = solution.force;
  side.status(c) = solution.status;
  return change;
}

// Hears of the changes of a sweep, chunk by chunk: see ConjugateSide.
struct Unheard {
  struct Sum {};
  static Sum start(std::size_t) { return {}; }
  static void add(std::size_t, const Vec3&, Sum&) {}
  static void finish(std::size_t, const Sum&) {}
};

// A sweep over contacts of one kind, of whose changes `heard` hears.
template <class Rule, class Side, class Before, class Heard>
void sweep(const Rule& rule, const Side& side, bool first, FrictionMemory& memory, const Team* team,
           const std::vector<Velocity>& start, std::vector<Velocity>& velocity,
           const Before& before, Heard& heard) {
  side.order.for_each_chunk(team, [&](std::size_t k, const ContactOrder::Chunk& chunk) {
    // Copies, of which the compiler knows that nothing else changes them.
    const Side here = side;
    Heard hears = heard;
    Real* const value = memory.value.data();
    const ContactStatus* const was = memory.status.data();
    auto sum = hears.start(k);
    for (std::size_t c = chunk.begin; c < chunk.end; ++c) {
      before(c);
      Real* const own = value + c * static_cast<std::size_t>(Rule::kValues);
      hears.add(c, solve(rule, here, c, first, was[c], start, velocity, own), sum);
    }
    hears.finish(k, sum);
  });
}

template <class Rule>
constexpr bool is_conjugate() {
  if constexpr (requires { Rule::kConjugate; }) {
    return Rule::kConjugate;
  } else {
    return false;
  }
}

template <class Side>
void remember_status(const Side& side, const Team* team, FrictionMemory& memory) {
  for_ranges(team, side.size(), kContactsToShare, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) memory.status[c] = side.status(c);
  });
}

template <class Friction>
void run(const Friction& mu, const Scene& scene, const Options& options, State& state,
         Workspace& workspace) {
  std::vector<Velocity>& velocity = workspace.velocity;
  const Team* const team = workspace.team;
  workspace.obstacle_order.make(workspace.contacts);
  if (!workspace.pair_order.is_for(workspace.pairs.size())) {
    workspace.pair_order.make(workspace.pairs, velocity.size());
  }
  workspace.edge_order.in_one_chunk(workspace.edges.size());
  const ObstacleSide<Friction> obstacles{scene, mu, options.dt(), workspace.contacts,
                                         workspace.obstacle_order};
  const PairSide<Friction> pairs{options, mu, workspace.pairs, workspace.pair_order};
  const EdgeSide<Friction> edges{options.dt(), mu, workspace.edges, workspace.edge_order};
  const bool known = with_friction_rule(options.rule, options.friction, [&](const auto& rule) {
    carry_memory(rule, state.obstacle_friction, obstacles, team, workspace.memory);
    carry_memory(rule, state.pair_friction, pairs, team, workspace.pair_friction);
    carry_memory(rule, state.edge_friction, edges, team, workspace.edge_friction);
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
      sweep(rule, pairs, first, workspace.pair_friction, team, state.velocity, velocity,
            normal_force, pairs_heard);
      sweep(rule, edges, first, workspace.edge_friction, team, state.velocity, velocity, nothing,
            edges_heard);
      sweep(rule, obstacles, first, workspace.memory, team, state.velocity, velocity, nothing,
            obstacles_heard);
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
  remember_status(obstacles, team, workspace.memory);
  remember_status(pairs, team, workspace.pair_friction);
  remember_status(edges, team, workspace.edge_friction);
  std::swap(state.obstacle_friction, workspace.memory);
  std::swap(state.pair_friction, workspace.pair_friction);
  std::swap(state.edge_friction, workspace.edge_friction);
  workspace.contact_updates += obstacles.size() + pairs.size() + edges.size();
}

}  // namespace stiction::friction_phase
