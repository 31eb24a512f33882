// SPDX-License-Identifier: BSD-3-Clause
#include "solver/step.h"

#include "solver/depth/depth.h"
#include "solver/depth/remember_pairs.h"
#include "solver/detection/crossing_edges.h"
#include "solver/detection/detect.h"
#include "solver/detection/detect_pairs.h"
#include "solver/elasticity/corotational.h"
#include "solver/friction/friction.h"
#include "solver/motion/integrate.h"
#include "solver/motion/loads.h"
#include "solver/motion/predict.h"
#include "solver/response/normal_force.h"
#include "solver/response/pair_normal_force.h"

namespace stiction {

void run_phase(Phase phase, const Scene& scene, const Options& options, State& state,
               Workspace& workspace) {
  const double dt = options.time_step;
  const double time = static_cast<double>(state.step) * dt;
  switch (phase) {
    case Phase::kForces:
      gravity_forces(scene, time, workspace.force, workspace.team);
      add_drag_forces(scene, time, state.velocity, workspace.force);
      add_load_forces(scene, time, state, workspace.force);
      if constexpr (STICTION_HAS_ELASTICITY) {
        if (workspace.team != nullptr) {
          add_corotational_forces(scene, state, *workspace.team, workspace.shares, workspace.force);
        } else {
          add_corotational_forces(scene, state, workspace.force);
        }
      }
      return;
    case Phase::kPredict: {
      const bool half = options.integrator == Integrator::kVerlet && state.step == 0;
      predict(static_cast<Real>(half ? 0.5 * dt : dt), workspace.force, state.velocity,
              workspace.velocity, workspace.team);
      if (scene.anything_moves_by_plan) follow_motions(scene, time, dt, workspace.velocity);
      return;
    }
    case Phase::kDetect:
      if (scene.pairs_possible) detect_pairs(scene, options, state, workspace);
      detect(scene, dt, state.position, workspace.velocity, workspace.contacts, time,
             scene.pairs_possible ? &workspace.search : nullptr, workspace.team);
      return;
    case Phase::kDepth:
      depths(scene, options, state, workspace);
      if (with_edges(options)) crossing_edges(scene, options, state, workspace);
      return;
    case Phase::kNormalForce:
      if (!workspace.pairs.empty() || !workspace.edges.empty())
        pair_normal_forces(scene, options, workspace, state.obstacle_friction);
      normal_forces(scene, dt, state, workspace);
      return;
    case Phase::kFriction:
      friction_forces(scene, options, state, workspace);
      return;
    case Phase::kIntegrate:
      if (scene.pairs_possible)
        remember_pairs(workspace.pairs, scene.topology, state.pair_geometry, workspace.team);
      integrate(options.dt(), workspace.velocity, state, workspace.team);
      return;
  }
}

void step(const Scene& scene, const Options& options, State& state, Workspace& workspace) {
  TeamChoice* const choice = workspace.team_choice;
  if (choice != nullptr) workspace.team = choice->begin_step();
  PhaseSeconds* const clock = STICTION_HAS_TIMING ? workspace.phase_seconds : nullptr;
  for (std::size_t p = 0; p < kPhaseNames.size(); ++p) {
    const auto phase = static_cast<Phase>(p);
    if (phase == Phase::kDepth && !scene.pairs_possible) continue;  // not even timed
    const PhaseTimer timer(clock, phase);
    run_phase(phase, scene, options, state, workspace);
  }
  if (choice != nullptr) choice->end_step();
  ++state.step;
}

}  // namespace stiction
