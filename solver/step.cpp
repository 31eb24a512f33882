// SPDX-License-Identifier: BSD-3-Clause
#include "solver/step.h"

#include "solver/elasticity/corotational.h"
#include "solver/phases/depth.h"
#include "solver/phases/detect.h"
#include "solver/phases/detect_pairs.h"
#include "solver/phases/friction.h"
#include "solver/phases/integrate.h"
#include "solver/phases/normal_force.h"
#include "solver/phases/pair_normal_force.h"
#include "solver/phases/predict.h"

namespace stiction {

void step(const Scene& scene, const Options& options, State& state, Workspace& workspace) {
  const double dt = options.time_step;
  const double time = static_cast<double>(state.step) * dt;
  PhaseSeconds* const clock = workspace.phase_seconds;
  {
    const PhaseTimer timer(clock, Phase::kForces);
    gravity_forces(scene, time, workspace.force);
    add_drag_forces(scene, time, state.velocity, workspace.force);
    add_corotational_forces(scene.elements, state, workspace.force);
  }
  {
    const PhaseTimer timer(clock, Phase::kPredict);
    const bool half = options.integrator == Integrator::kVerlet && state.step == 0;
    predict(half ? 0.5 * dt : dt, workspace.force, state.velocity, workspace.velocity);
    if (scene.anything_moves_by_plan) follow_motions(scene, time, dt, workspace.velocity);
  }
  {
    const PhaseTimer timer(clock, Phase::kDetect);
    detect(scene, dt, state.position, workspace.velocity, workspace.contacts, time);
    if (scene.pairs_possible) detect_pairs(scene, options, state, workspace);
  }
  if (scene.pairs_possible) {
    const PhaseTimer timer(clock, Phase::kDepth);
    depths(scene, options, state, workspace);
  }
  {
    const PhaseTimer timer(clock, Phase::kNormalForce);
    if (!workspace.pairs.empty()) pair_normal_forces(scene, options, workspace);
    normal_forces(scene, dt, state.position, workspace.velocity, workspace.contacts, time);
  }
  {
    const PhaseTimer timer(clock, Phase::kFriction);
    friction_forces(scene, options, state, workspace);
  }
  {
    const PhaseTimer timer(clock, Phase::kIntegrate);
    if (scene.pairs_possible) remember_pairs(workspace.pairs, scene.topology, state.pair_memory);
    integrate(dt, workspace.velocity, state);
  }
  ++state.step;
}

}  // namespace stiction
