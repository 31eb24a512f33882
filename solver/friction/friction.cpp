// SPDX-License-Identifier: BSD-3-Clause
#include "solver/friction/friction.h"

#include "solver/friction/friction_phase.h"

namespace stiction {

namespace {

// μ where all bodies, and all against an obstacle, have the same.
struct CommonFriction {
  Real between_bodies;
  Real between(std::int32_t, std::int32_t) const { return between_bodies; }
  Real against(const HalfSpace& obstacle, std::int32_t, std::int32_t) const {
    return obstacle.friction;
  }
};

}  // namespace

void friction_forces(const Scene& scene, const Options& options, State& state,
                     Workspace& workspace) {
  if (!scene.own_friction.empty()) {
    friction_forces_of_pairs(scene, options, state, workspace);
    return;
  }
  friction_phase::run(CommonFriction{scene.friction}, scene, options, state, workspace);
}

}  // namespace stiction
