// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: what a rule has learned, and that a contact stuck, outlive its slip.
#include <algorithm>

#include "solver/friction/catalog.h"
#include "solver/friction/friction.h"

namespace stiction {

void unplanted_friction_forces(const Scene& scene, const Options& options, State& state,
                               Workspace& workspace);

namespace {

bool stuck(const FrictionMemory& last, ContactKey key) {
  const auto found = std::lower_bound(last.key.begin(), last.key.end(), key);
  return found != last.key.end() && *found == key &&
         last.status[static_cast<std::size_t>(found - last.key.begin())] == ContactStatus::kStick;
}

void keep_sticking(const FrictionMemory& last, FrictionMemory& memory) {
  for (std::size_t c = 0; c < memory.key.size(); ++c) {
    if (stuck(last, memory.key[c])) memory.status[c] = ContactStatus::kStick;
  }
}

}  // namespace

void friction_forces(const Scene& scene, const Options& options, State& state,
                     Workspace& workspace) {
  Options kept = options;
  for (const RuleParameter& one : friction_rule_parameters(options.rule)) {
    if (one.name == std::string("memory")) kept.friction[one.name] = 1.0;
  }
  const FrictionMemory obstacles = state.obstacle_friction, pairs = state.pair_friction,
                       edges = state.edge_friction;
  unplanted_friction_forces(scene, kept, state, workspace);
  keep_sticking(obstacles, state.obstacle_friction);
  keep_sticking(pairs, state.pair_friction);
  keep_sticking(edges, state.edge_friction);
}

}  // namespace stiction
