// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/piles/pyramid_problem.h"

#include <cmath>

#include "reference/limit/limit_scenes.h"
#include "reference/meshes/box_mesh.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

int box_count(const PyramidSetup& setup) { return setup.rows * (setup.rows + 1) / 2; }

Problem pyramid_problem(const PyramidSetup& setup) {
  Problem problem;
  problem.name = "box pyramid";
  const double pitch = setup.width + setup.gap;
  for (int row = 0; row < setup.rows; ++row) {
    for (int k = 0; k < setup.rows - row; ++k) {
      ProblemBody box;
      box.name = "box " + std::to_string(row + 1) + "." + std::to_string(k + 1);
      box.shape = MeshShape{
          reference::box_mesh(Vec3::Constant(setup.width), Eigen::Vector3i::Constant(setup.cells))};
      box.mass = setup.box_mass;
      box.elasticity = setup.elasticity;
      // Rows are shifted by 4 mm across the slope in turn, so that no vertex lies on an edge.
      const double shift = setup.flush ? 0.0 : 2e-3 * (row % 2 == 0 ? 1 : -1);
      box.position =
          Vec3(pitch * (k + 0.5 * (row + 1 - setup.rows)), shift, setup.width * (row + 0.5));
      problem.bodies.push_back(box);
    }
  }
  if (setup.rigid_ground) {
    problem.obstacles = {{.name = "ground", .friction = setup.friction}};
  } else {
    const Vec3 size(pitch * setup.rows + setup.width, 1.6 * setup.width, setup.slab_height);
    ProblemBody slab;
    slab.name = "slab";
    const Eigen::Vector3i cells =
        (size * setup.cells / setup.width).array().floor().cast<int>().max(1);
    slab.shape = MeshShape{reference::box_mesh(size, cells)};
    slab.mass = setup.box_mass * size.prod() / std::pow(setup.width, 3);
    slab.elasticity = setup.elasticity;
    slab.position = Vec3(0.3 * setup.gap, 0, -0.5 * setup.slab_height);
    slab.held = HeldPart{Vec3(0, 0, -0.5 * setup.slab_height), Vec3::UnitZ()};
    problem.bodies.push_back(slab);
  }
  problem.friction = setup.friction;
  const double cosine = 1.0 / std::hypot(1.0, setup.tan_slope);
  const Vec3 into(0, 0, -kStandardGravity * cosine);
  const Vec3 full = into + Vec3(kStandardGravity * cosine * setup.tan_slope, 0, 0);
  problem.gravity = {{0.0, kPressed, kTilts, kTilted}, {Vec3::Zero(), into, into, full}};
  return problem;
}

reference::LimitBracket pyramid_limit(const PyramidSetup& setup) {
  return reference::critical_load(
      reference::box_pyramid(setup.rows, setup.gap / setup.width, false), setup.friction);
}

}  // namespace stiction
