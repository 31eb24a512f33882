// SPDX-License-Identifier: BSD-3-Clause
#include "solver/friction/friction.h"
#include "solver/friction/friction_phase.h"

namespace stiction {

namespace {

// μ where pairs have one of their own.
struct PairsOwnFriction {
  const FrictionTable& table;
  Real between(std::int32_t vertex, std::int32_t other) const {
    return table.between(vertex, other);
  }
  Real against(const HalfSpace&, std::int32_t vertex, std::int32_t obstacle) const {
    return table.against_obstacle(vertex, obstacle);
  }
};

}  // namespace

void friction_forces_of_pairs(const Scene& scene, const Options& options, State& state,
                              Workspace& workspace) {
  friction_phase::run(PairsOwnFriction{scene.own_friction}, scene, options, state, workspace);
}

}  // namespace stiction
