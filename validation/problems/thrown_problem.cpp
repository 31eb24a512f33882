// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/thrown_problem.h"

#include <cmath>

namespace stiction {

Problem thrown_problem(const ThrownSetup& setup) {
  Problem problem;
  problem.name = "a body thrown at the ground";
  const double height = setup.ball ? setup.size : 0.5 * setup.height;
  ProblemBody body{.name = setup.ball ? "ball" : "box",
                   .shape = BoxShape{{setup.size, setup.size, setup.height}},
                   .mass = setup.mass,
                   .elasticity = setup.elasticity,
                   .position = Vec3(0.0, 0.0, height + setup.gap),
                   .velocity = setup.along * thrown_along(setup) - setup.approach * Vec3::UnitZ()};
  if (setup.ball) body.shape = BallShape{setup.size};
  body.rotation = Eigen::AngleAxisd(setup.yaw, Vec3::UnitZ());
  problem.bodies = {body};
  problem.obstacles = {{.name = "ground", .friction = setup.friction}};
  return problem;
}

Vec3 thrown_along(const ThrownSetup& setup) {
  return {std::cos(setup.azimuth), std::sin(setup.azimuth), 0.0};
}

}  // namespace stiction
