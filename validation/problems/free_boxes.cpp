// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/free_boxes.h"

namespace stiction {

ProblemBody free_cube(const char* name, const Vec3& position, const Vec3& velocity,
                      double damping_time, const Eigen::Quaterniond& rotation) {
  return {.name = name,
          .shape = BoxShape{{0.1, 0.1, 0.1}},
          .mass = 1.0,
          .elasticity = {.youngs_modulus = 5e5, .poisson_ratio = 0.3, .damping_time = damping_time},
          .position = position,
          .rotation = rotation,
          .velocity = velocity};
}

Problem free_problem(const char* name, const std::vector<ProblemBody>& bodies, double duration) {
  return {.name = name,
          .bodies = bodies,
          .obstacles = {},
          .gravity = {},
          .friction = 0.5,
          .duration = duration};
}

CaseRun::Running simulate_free(CaseRun& run, const Problem& problem, const Settings& over) {
  CaseRun::Running simulation = run.simulate_with(over, problem, {.fineness = 4});
  simulation->record_frames(1e-3);
  return simulation;
}

double momentum_scale(const Problem& problem) {
  double scale = 0.0;
  for (const ProblemBody& body : problem.bodies) scale += body.mass * body.velocity.norm();
  return scale;
}

}  // namespace stiction
