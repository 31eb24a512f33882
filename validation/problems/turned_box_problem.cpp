// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/turned_box_problem.h"

#include <numbers>

#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

Problem turned_box_problem(const TurnedBoxSetup& setup) {
  Problem problem;
  problem.name = "a box turned by a couple";
  ProblemBody box{.name = "box",
                  .shape = BoxShape{{setup.face, setup.face, setup.height}},
                  .mass = setup.mass,
                  .elasticity = setup.elasticity,
                  .position = Vec3(0.0, 0.0, 0.5 * setup.height)};
  box.rotation = Eigen::AngleAxisd(setup.yaw, Vec3::UnitZ());
  problem.bodies = {box};
  problem.obstacles = {{.name = "ground", .friction = setup.friction}};
  problem.gravity = {{0.0, kTurnWeighs}, {Vec3::Zero(), -kStandardGravity * Vec3::UnitZ()}};
  problem.loads = {
      {.body = 0,
       .force = {},
       .couple = {{kTurnFrom, kTurnFull}, {Vec3::Zero(), setup.couple * Vec3::UnitZ()}}}};
  return problem;
}

double most_couple(const TurnedBoxSetup& setup) {
  return setup.friction * setup.mass * kStandardGravity * setup.face / std::numbers::sqrt2;
}

}  // namespace stiction
