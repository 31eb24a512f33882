// SPDX-License-Identifier: BSD-3-Clause
#include "solver/phases/friction.h"

#include <algorithm>

#include "solver/demand.h"
#include "solver/friction/catalog.h"
#include "solver/mutation.h"

namespace stiction {

namespace {

Vec3 tangential(const Vec3& v, const Vec3& normal) { return v - normal.dot(v) * normal; }

// Moves the memory of the contacts that persist to their new places, both lists being in the order
// of their keys, and resets it for the others.
template <class Rule>
void carry_memory(const Rule& rule, const FrictionMemory& old, const OneSidedContacts& contacts,
                  FrictionMemory& memory) {
  constexpr auto kValues = static_cast<std::size_t>(Rule::kValues);
  memory.key = contacts.key;
  memory.status.resize(contacts.size());
  memory.value.resize(contacts.size() * kValues);
  std::size_t from = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    while (from < old.key.size() && old.key[from] < memory.key[c]) ++from;
    const bool persists = from < old.key.size() && old.key[from] == memory.key[c] &&
                          old.value.size() == old.key.size() * kValues;
    double* const value = memory.value.data() + c * kValues;
    if (persists) {
      memory.status[c] = old.status[from];
      std::copy_n(old.value.data() + from * kValues, kValues, value);
    } else {
      memory.status[c] = ContactStatus::kNew;
      rule.reset(value);
    }
  }
}

template <class Rule>
void sweep(const Rule& rule, const Scene& scene, double dt, const std::vector<Velocity>& start,
           std::vector<Velocity>& velocity, OneSidedContacts& contacts, FrictionMemory& memory) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto i = static_cast<std::size_t>(contacts.vertex[c]);
    const HalfSpace& obstacle = scene.half_spaces[static_cast<std::size_t>(contacts.obstacle[c])];
    double mu = obstacle.friction;
    if constexpr (kMutation == Mutation::kFrictionScaled) mu *= 1.02;

    const SlipProblem problem{.free_slip = tangential(velocity[i].v, obstacle.normal),
                              .start_slip = tangential(start[i].v, obstacle.normal),
                              .inverse_mass = dt * velocity[i].inverse_mass,
                              .bound = mu * contacts.normal_force[c],
                              .was = memory.status[c]};
    SlipSolution solution =
        rule.solve(problem, memory.value.data() + c * static_cast<std::size_t>(Rule::kValues));
    if constexpr (kMutation == Mutation::kFrictionSign) solution.force = -solution.force;

    velocity[i].v += problem.inverse_mass * solution.force;
    contacts.friction_force[c] = solution.force;
    contacts.status[c] = solution.status;
    memory.status[c] = solution.status;
  }
}

}  // namespace

void friction_forces(const Scene& scene, const Options& options, State& state,
                     Workspace& workspace) {
  OneSidedContacts& contacts = workspace.contacts;
  const bool known = with_friction_rule(options.rule, options.friction, [&](const auto& rule) {
    carry_memory(rule, state.memory, contacts, workspace.memory);
    sweep(rule, scene, options.time_step, state.velocity, workspace.velocity, contacts,
          workspace.memory);
  });
  demand(known, "the options were checked, so the friction rule exists");
  std::swap(state.memory, workspace.memory);
  workspace.contact_updates += contacts.size();
}

}  // namespace stiction
