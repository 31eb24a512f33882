// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/piles/arch_problem.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

// Corners of a joint: inside and outside, at −depth/2 and depth/2 in turn, m.
std::array<Vec3, 4> joint(const ArchSetup& setup, int j) {
  const double angle = std::numbers::pi * j / setup.blocks;
  // The ends lie in the ground's plane exactly, and the arch is its own mirror image.
  const bool end = j == 0 || j == setup.blocks;
  const double sine = end ? 0.0 : std::sin(std::min(angle, std::numbers::pi - angle));
  const double cosine = 2 * j == setup.blocks ? 0.0 : std::cos(angle);
  const Vec3 outwards(-cosine, 0.0, sine), across(0.0, 0.5 * setup.depth, 0.0);
  const Vec3 in = (setup.radius - 0.5 * setup.thickness) * outwards;
  const Vec3 out = (setup.radius + 0.5 * setup.thickness) * outwards;
  return {in - across, out - across, in + across, out + across};
}

struct Block {
  TetMesh mesh;                // about the centre of mass
  Vec3 centre = Vec3::Zero();  // m
  double volume = 0.0;         // m³
};

// A hexahedron as six tetrahedra about the diagonal from the first corner of one joint to the last
// of the other; all quadrilaterals are plane.
Block block(const ArchSetup& setup, int k) {
  const std::array<Vec3, 4> a = joint(setup, k), b = joint(setup, k + 1);
  Block one;
  one.mesh.vertices.resize(3, 8);
  for (int c = 0; c < 4; ++c) {
    one.mesh.vertices.col(c) = a[static_cast<std::size_t>(c)];
    one.mesh.vertices.col(4 + c) = b[static_cast<std::size_t>(c)];
  }
  // Ways from corner 0 to corner 7 along three edges of the cube, bit by bit.
  constexpr std::array<std::array<int, 2>, 6> ways{
      {{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}}};
  one.mesh.tetrahedra.resize(4, 6);
  for (Eigen::Index e = 0; e < 6; ++e) {
    const auto& way = ways[static_cast<std::size_t>(e)];
    one.mesh.tetrahedra.col(e) << 0, way[0], way[1], 7;
    if (signed_volume(one.mesh, e) < 0.0) one.mesh.tetrahedra.col(e) << 0, way[1], way[0], 7;
    const double volume = signed_volume(one.mesh, e);
    Vec3 middle = Vec3::Zero();
    for (int c = 0; c < 4; ++c) {
      middle += 0.25 * one.mesh.vertices.col(one.mesh.tetrahedra(c, e));
    }
    one.volume += volume;
    one.centre += volume * middle;
  }
  one.centre /= one.volume;
  one.mesh.vertices.colwise() -= one.centre;
  return one;
}

}  // namespace

Problem arch_problem(const ArchSetup& setup) {
  Problem problem;
  problem.name = "arch";
  for (int k = 0; k < setup.blocks; ++k) {
    const Block one = block(setup, k);
    problem.bodies.push_back({.name = fmt::format("voussoir {}", k + 1),
                              .shape = MeshShape{.mesh = one.mesh, .convex = true},
                              .mass = setup.density * one.volume,
                              .elasticity = setup.elasticity,
                              .position = one.centre});
  }
  problem.obstacles = {{.name = "ground", .friction = setup.friction}};
  problem.friction = setup.friction;
  problem.gravity = {{0.0, setup.full}, {Vec3::Zero(), -kStandardGravity * Vec3::UnitZ()}};
  if (setup.drag_ends > 0.0) {
    problem.drag = {.rate = 40.0, .full_until = setup.drag_ends - 0.2, .ends = setup.drag_ends};
  }
  return problem;
}

reference::LimitProblem arch_limit(const ArchSetup& setup) {
  reference::LimitProblem problem;
  for (int k = 0; k < setup.blocks; ++k) {
    const Block one = block(setup, k);
    problem.bodies.push_back({setup.density * one.volume, one.centre});
  }
  for (int j = 0; j <= setup.blocks; ++j) {
    const double angle = std::numbers::pi * j / setup.blocks;
    const bool end = j == 0 || j == setup.blocks;
    // From the block before the joint to the one after it, or out of the ground.
    const Vec3 normal = end ? Vec3(Vec3::UnitZ()) : Vec3(std::sin(angle), 0.0, std::cos(angle));
    const int after = j == setup.blocks ? j - 1 : j;
    const int before = end ? reference::kFixed : j - 1;
    for (const Vec3& corner : joint(setup, j)) {
      problem.contacts.push_back({after, before, corner, normal, 1.0});
    }
  }
  return problem;
}

double least_thickness(ArchSetup setup) {
  double stands = 0.2 * setup.radius, falls = 0.05 * setup.radius;
  while (stands - falls > 1e-6 * setup.radius) {
    setup.thickness = 0.5 * (stands + falls);
    const bool can = reference::equilibrium(arch_limit(setup), setup.friction).answer ==
                     reference::Equilibrium::exists;
    (can ? stands : falls) = setup.thickness;
  }
  return reference::in_nine_digits(0.5 * (stands + falls));
}

}  // namespace stiction
