// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/piles/plates_problem.h"

#include <cmath>

#include "reference/meshes/box_mesh.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

Problem plates_problem(const PlatesSetup& setup) {
  const auto plate = [&](const std::string& name, int cells) {
    const double width = kPlateCell * cells;
    return ProblemBody{
        .name = name,
        .shape = MeshShape{reference::box_mesh(Vec3(width, width, kPlateCell), {cells, cells, 1})},
        .mass = setup.density * kPlateCell * kPlateCell * kPlateCell * cells * cells,
        .elasticity = setup.elasticity};
  };
  ProblemBody upper = plate("upper", setup.cells);
  upper.position = Vec3(0.013, 0.007, 0.5 * kPlateCell);
  upper.rotation = Eigen::AngleAxisd(0.3, Vec3::UnitZ());
  ProblemBody lower = plate("lower", static_cast<int>(std::ceil(1.3 * setup.cells)) + 1);
  lower.position = Vec3(0.0, 0.0, -0.5 * kPlateCell);
  lower.held = HeldPart{Vec3(0.0, 0.0, -0.5 * kPlateCell), Vec3::UnitZ()};
  Problem problem;
  problem.name = "plates";
  problem.bodies = {upper, lower};
  problem.friction = 0.5;
  problem.gravity = {
      {0.0},
      {kStandardGravity / std::hypot(1.0, setup.tan_slope) * Vec3(setup.tan_slope, 0.0, -1.0)}};
  return problem;
}

}  // namespace stiction
