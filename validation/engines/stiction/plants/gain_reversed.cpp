// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: rules learn, or correct what they store, with the wrong sign.
#include "solver/friction/catalog.h"
#include "solver/friction/friction.h"

namespace stiction {

void unplanted_friction_forces(const Scene& scene, const Options& options, State& state,
                               Workspace& workspace);

void friction_forces(const Scene& scene, const Options& options, State& state,
                     Workspace& workspace) {
  Options reversed = options;
  for (const RuleParameter& one : friction_rule_parameters(options.rule)) {
    const std::string name = one.name;
    if (name == "gain" || name == "alpha" || name == "relaxation") {
      reversed.friction[name] = -value_of(one, options.friction);
    }
  }
  unplanted_friction_forces(scene, reversed, state, workspace);
}

}  // namespace stiction
