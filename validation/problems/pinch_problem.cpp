// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/pinch_problem.h"

#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

Eigen::Quaterniond turned(const PinchSetup& setup) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(setup.azimuth, Vec3::UnitZ()));
}

}  // namespace

Problem pinch_problem(const PinchSetup& setup) {
  const Eigen::Quaterniond turn = turned(setup);
  const Vec3 across = pinch_across(setup);
  const Vec3 centre(0.0, 0.0, 0.5 * setup.jaw.z());
  const double reach = 0.5 * (setup.edge + setup.jaw.x());
  Problem problem;
  problem.name = "pinch";
  problem.bodies = {{.name = "body",
                     .shape = BoxShape{Vec3::Constant(setup.edge)},
                     .mass = setup.mass,
                     .elasticity = setup.elasticity,
                     .position = centre,
                     .rotation = turn}};
  const double weight = setup.mass * kStandardGravity;
  problem.loads = {
      {.body = 0,
       .force = {{0.0, kPinchWeighs, kPinchLetGo, kPinchFree},
                 {Vec3::Zero(), weight * Vec3::UnitZ(), weight * Vec3::UnitZ(), Vec3::Zero()}}}};
  for (const double side : {-1.0, 1.0}) {
    problem.loads.push_back(
        {.body = problem.bodies.size(),
         .force = {{kPinchFrom, kPinchClosed}, {Vec3::Zero(), -side * setup.force * across}}});
    problem.springs.push_back({.body = problem.bodies.size(),
                               .anchor = centre + side * reach * across,
                               .axis = turn * Vec3::UnitY(),
                               .stiffness = setup.guide});
    problem.bodies.push_back({.name = side < 0.0 ? "left jaw" : "right jaw",
                              .shape = BoxShape{setup.jaw},
                              .mass = setup.jaw_mass,
                              .elasticity = setup.elasticity,
                              .position = centre + side * reach * across,
                              .rotation = turn});
  }
  problem.obstacles = {{.name = "floor", .friction = 0.0}};
  problem.gravity = {{0.0, kPinchWeighs}, {Vec3::Zero(), -kStandardGravity * Vec3::UnitZ()}};
  problem.drag = {.rate = 60.0, .full_until = setup.settled - 0.1, .ends = setup.settled};
  problem.friction = setup.friction;
  return problem;
}

Vec3 pinch_across(const PinchSetup& setup) { return turned(setup) * Vec3::UnitX(); }

double least_pinch(const PinchSetup& setup) {
  return setup.mass * kStandardGravity / (2.0 * setup.friction);
}

}  // namespace stiction
