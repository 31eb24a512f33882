// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/piles/stack_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/limit/limit_scenes.h"
#include "reference/limit/no_tension_column.h"
#include "reference/meshes/box_mesh.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

// As many cells as make them about as large as the boxes' along x.
Eigen::Vector3i cells_of(const Vec3& size, const StackSetup& setup) {
  const double cell = setup.size.x() / setup.cells;
  return (size / cell).array().round().cast<int>().max(1);
}

ProblemBody ground_of(const StackSetup& setup) {
  Vec3 size = setup.size;
  if (setup.ground == Ground::kSlab) size = size.cwiseProduct(Vec3(3.0, 3.0, 1.0));
  ProblemBody slab;
  slab.name = setup.ground == Ground::kSlab ? "slab" : "base";
  slab.shape = MeshShape{reference::box_mesh(size, cells_of(size, setup))};
  slab.mass = setup.density * size.prod();
  slab.elasticity = setup.elasticity;
  slab.position = Vec3(0.0, 0.0, -0.5 * size.z());
  slab.held = HeldPart{slab.position, Vec3::UnitZ()};
  return slab;
}

}  // namespace

std::string word(Ground ground) {
  switch (ground) {
    case Ground::kRigid:
      return "rigid";
    case Ground::kSlab:
      return "slab";
    case Ground::kFlush:
      return "flush-base";
  }
  return {};
}

Drag settling_drag(const StackSetup& setup) {
  const double height = setup.boxes * setup.size.z();
  const double speed = std::sqrt(setup.elasticity.youngs_modulus / (12.0 * setup.density));
  const double omega = 3.516 * speed * setup.size.x() / (height * height);
  // What sways faster than 40 rad/s is ended soon enough by less.
  return {.rate = 1.5 * std::min(omega, 40.0), .full_until = 7.0, .ends = 8.0};
}

Problem stack_problem(const StackSetup& setup) {
  Problem problem;
  problem.name = "stack";
  const TetMesh mesh = reference::box_mesh(setup.size, cells_of(setup.size, setup));
  for (int k = 0; k < setup.boxes; ++k) {
    ProblemBody box;
    box.name = fmt::format("box {}", k + 1);
    box.shape = MeshShape{mesh};
    box.mass = setup.density * setup.size.prod() * (k + 1 == setup.boxes ? setup.top_density : 1.0);
    box.elasticity = setup.elasticity;
    box.position = Vec3(0.0, 0.0, setup.size.z() * (k + 0.5));
    if (!setup.turns.empty()) {
      box.rotation = Eigen::AngleAxisd(setup.turns.at(static_cast<std::size_t>(k)), Vec3::UnitZ());
    }
    problem.bodies.push_back(box);
  }
  if (setup.ground == Ground::kRigid) {
    problem.obstacles = {{.name = "ground", .friction = setup.friction}};
  } else {
    problem.bodies.push_back(ground_of(setup));
  }
  problem.friction = setup.friction;
  const double cosine = 1.0 / std::hypot(1.0, setup.tan_slope);
  const Vec3 into(0.0, 0.0, -kStandardGravity * cosine);
  const Vec3 full = into + Vec3(kStandardGravity * cosine * setup.tan_slope, 0.0, 0.0);
  problem.gravity = {{0.0, kStackPressed, kStackTilts, kStackTilted},
                     {Vec3::Zero(), into, into, full}};
  problem.drag = settling_drag(setup);
  return problem;
}

StackLimit critical_tan(const StackSetup& setup) {
  StackLimit limit;
  limit.rigid =
      reference::critical_load(reference::box_stack(setup.boxes, setup.size), setup.friction).lower;
  // A ground that gives way lets the stack lean like one box more.
  const int boxes = setup.boxes + (setup.ground == Ground::kRigid ? 0 : 1);
  const reference::Column column{.height = boxes * setup.size.z(),
                                 .width = setup.size.x(),
                                 .youngs_modulus = setup.elasticity.youngs_modulus,
                                 .weight_density = setup.density * kStandardGravity};
  limit.elastic = std::min(limit.rigid, reference::critical_tan(column));
  return limit;
}

std::string stack_words(const StackSetup& setup) {
  return fmt::format("{} boxes at {:.2f}°, {} cell{} an edge", setup.boxes,
                     std::atan(setup.tan_slope) * 180.0 / std::numbers::pi, setup.cells,
                     setup.cells == 1 ? "" : "s");
}

}  // namespace stiction
