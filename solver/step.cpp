// SPDX-License-Identifier: BSD-3-Clause
#include "solver/step.h"

#include "solver/elasticity/corotational.h"
#include "solver/phases/detect.h"
#include "solver/phases/friction.h"
#include "solver/phases/integrate.h"
#include "solver/phases/normal_force.h"
#include "solver/phases/predict.h"

namespace stiction {

void step(const Scene& scene, const Options& options, State& state, Workspace& workspace) {
  const double dt = options.time_step;
  PhaseSeconds* const clock = workspace.phase_seconds;
  {
    const PhaseTimer timer(clock, Phase::kForces);
    gravity_forces(scene, static_cast<double>(state.step) * dt, workspace.force);
    add_corotational_forces(scene.elements, state, workspace.force);
  }
  {
    const PhaseTimer timer(clock, Phase::kPredict);
    predict(dt, workspace.force, state.velocity, workspace.velocity);
  }
  {
    const PhaseTimer timer(clock, Phase::kDetect);
    detect(scene, dt, state.position, workspace.velocity, workspace.contacts);
  }
  {
    const PhaseTimer timer(clock, Phase::kNormalForce);
    normal_forces(scene, dt, state.position, workspace.velocity, workspace.contacts);
  }
  {
    const PhaseTimer timer(clock, Phase::kFriction);
    friction_forces(scene, options, state, workspace);
  }
  {
    const PhaseTimer timer(clock, Phase::kIntegrate);
    integrate(dt, workspace.velocity, state);
  }
  ++state.step;
}

}  // namespace stiction
