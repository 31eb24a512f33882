// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/gauntlet/tip_collision_problem.h"

#include <fmt/format.h>

namespace stiction {

namespace {

// A tip at the origin that points up (side = 1) or down.
TetMesh pointed(bool ridge, double side) {
  constexpr double kEdge = 0.06, kHeight = 0.015, kBlock = 0.03;  // m
  TetMesh mesh =
      ridge
          ? wedge_mesh({.width = kEdge, .height = side * kHeight, .block = kBlock, .length = kEdge})
          : spike_bed_mesh({.pad = kEdge, .height = side * kHeight, .block = kBlock});
  mesh.vertices.row(2).array() -= side * kHeight;
  return mesh;
}

}  // namespace

Problem tip_collision_problem(const TipCollisionSetup& setup) {
  constexpr double kApart = 1e-3;  // m
  Problem problem;
  problem.name = "tip on tip";
  problem.bodies = {
      gauntlet_body("lower", pointed(setup.ridges, 1.0), Vec3(0.0, 0.0, -0.5 * kApart)),
      gauntlet_body("upper", pointed(setup.ridges, -1.0),
                    Vec3(setup.offset.x(), setup.offset.y(), 0.5 * kApart), yawed(setup.yaw))};
  problem.bodies[0].velocity = Vec3(0.0, 0.0, setup.speed);
  problem.bodies[1].velocity = Vec3(0.0, 0.0, -setup.speed);
  problem.friction = setup.friction;
  problem.duration = setup.duration;
  return problem;
}

std::string tip_collision_words(const TipCollisionSetup& setup) {
  return fmt::format("{}, ({:g}, {:g}) mm off, turned by {:.0f}°",
                     setup.ridges ? "ridges" : "spikes", 1e3 * setup.offset.x(),
                     1e3 * setup.offset.y(), setup.yaw);
}

}  // namespace stiction
