// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/oscillator_problem.h"

#include <cmath>

#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

Problem oscillator_problem(const OscillatorSetup& setup) {
  const Vec3 axis = oscillator_axis(setup);
  Problem problem;
  problem.name = "oscillator with friction";
  ProblemBody box{.name = "box",
                  .shape = BoxShape{setup.size},
                  .mass = setup.mass,
                  .elasticity = setup.elasticity,
                  .position = Vec3(0.0, 0.0, 0.5 * setup.size.z())};
  problem.bodies = {box};
  problem.obstacles = {{.name = "ground", .friction = setup.friction}};
  problem.gravity = {{0.0}, {-kStandardGravity * Vec3::UnitZ()}};
  problem.springs = {{.body = 0,
                      .anchor = box.position - setup.stretch * oscillator_offset(setup) * axis,
                      .anchor_velocity = setup.drawn * axis,
                      .axis = axis,
                      .stiffness = setup.stiffness}};
  return problem;
}

Vec3 oscillator_axis(const OscillatorSetup& setup) {
  return {std::cos(setup.azimuth), std::sin(setup.azimuth), 0.0};
}

double oscillator_rate(const OscillatorSetup& setup) {
  return std::sqrt(setup.stiffness / setup.mass);
}

double oscillator_offset(const OscillatorSetup& setup) {
  return setup.friction * setup.mass * kStandardGravity / setup.stiffness;
}

}  // namespace stiction
