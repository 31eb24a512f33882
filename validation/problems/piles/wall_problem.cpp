// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/piles/wall_problem.h"

#include <fmt/format.h>

#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

bool has_halves(const WallSetup& setup, int course) { return setup.bricks > 1 && course % 2 == 1; }

}  // namespace

Problem wall_problem(const WallSetup& setup) {
  const double edge = setup.edge, pitch = edge + setup.joint;
  Problem problem;
  problem.name = setup.bricks > 1 ? "wall" : "stack";
  const auto add = [&](int course, double x, double length) {
    problem.bodies.push_back(
        {.name = fmt::format("brick {} of course {}", problem.bodies.size() + 1, course + 1),
         .shape = BoxShape{{length, edge, edge}},
         .mass = setup.density * length * edge * edge,
         .elasticity = setup.elasticity,
         .position = Vec3(x, 0.0, (course + 0.5) * edge)});
  };
  const double left = -0.5 * pitch * (setup.bricks - 1);  // the first brick's centre
  for (int course = 0; course < setup.courses; ++course) {
    const bool halves = has_halves(setup, course);
    const double half = 0.5 * (edge - setup.joint), end = 0.5 * (edge - half);
    if (halves) add(course, left - end, half);
    for (int k = 0; k < setup.bricks - (halves ? 1 : 0); ++k) {
      add(course, left + pitch * (k + (halves ? 0.5 : 0.0)), edge);
    }
    if (halves) add(course, -left + end, half);
  }
  problem.obstacles = {{.name = "ground", .friction = setup.friction}};
  problem.friction = setup.friction;
  problem.gravity = {{0.0, setup.full}, {Vec3::Zero(), -kStandardGravity * Vec3::UnitZ()}};
  if (setup.drag_ends > 0.0) {
    problem.drag = {.rate = 40.0, .full_until = setup.drag_ends - 0.2, .ends = setup.drag_ends};
  }
  return problem;
}

std::vector<std::size_t> top_course(const WallSetup& setup) {
  const std::size_t all = wall_problem(setup).bodies.size();
  const int count = setup.bricks + (has_halves(setup, setup.courses - 1) ? 1 : 0);
  std::vector<std::size_t> top;
  for (std::size_t b = all - static_cast<std::size_t>(count); b < all; ++b) top.push_back(b);
  return top;
}

double elastic_fall(const WallSetup& setup, int cells) {
  const double h = setup.edge, height = h * setup.courses, z = height - 0.5 * h;
  const double spread = h * h / 12.0 * (cells > 0 ? 1.0 + 2.0 / (cells * cells) : 1.0);
  return setup.density * kStandardGravity / setup.elasticity.youngs_modulus *
         (height * z - 0.5 * (z * z + spread));
}

}  // namespace stiction
