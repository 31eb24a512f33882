// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/bar_problem.h"

namespace stiction {

Problem bar_problem(const BarSetup& setup) {
  Problem problem;
  problem.name = "bar on a frictional bed";
  ProblemBody body{.name = "bar",
                   .shape = BoxShape{{setup.length, setup.side, setup.side}},
                   .mass = setup.density * setup.side * setup.side * setup.length,
                   .elasticity = {.youngs_modulus = setup.modulus,
                                  .poisson_ratio = 0.0,
                                  .damping_time = setup.damping_time},
                   .position = {0.5 * setup.length, 0.0, 0.5 * setup.side}};
  body.held = HeldPart{Vec3(-0.5 * setup.length, 0.0, 0.0), Vec3::UnitX()};
  const Vec3 pushed = bar_push(setup) * Vec3::UnitX();
  const double t = setup.settled, ramp = setup.ramp, turn = bar_turn(setup);
  body.motion = {{t, t + ramp, t + turn, t + turn + ramp, t + 2.0 * turn, t + 2.0 * turn + ramp},
                 {Vec3::Zero(), pushed, pushed, Vec3::Zero(), Vec3::Zero(), pushed}};
  problem.bodies = {body};
  problem.obstacles = {{.name = "bed", .friction = setup.friction}};
  problem.gravity = {{0.0, 0.1}, {Vec3::Zero(), -kStandardGravity * Vec3::UnitZ()}};
  problem.duration = setup.settled + 3.0 * turn;
  return problem;
}

}  // namespace stiction
