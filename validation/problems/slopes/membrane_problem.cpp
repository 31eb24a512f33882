// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/slopes/membrane_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "reference/meshes/box_mesh.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

constexpr int kBlockCells = 3, kLayers = 5, kMiddle = 2;

double sag(const reference::MembraneProblem& string, double x) {
  const double s = string.start;
  const double kink = x < s ? x * (string.length - s) : (string.length - x) * s;
  return string.own_load * x * (string.length - x) / (2.0 * string.tension) +
         string.box_load / (string.tension * string.length) * kink;
}

// The string while gravity grows.
reference::MembraneProblem first_string(const MembraneSetup& setup) {
  MembraneSetup first = setup;
  first.tan_slope = kMembraneFirstTangent;
  return membrane_string(first);
}

// Cells of one lattice: the block has them all, the strip only the middle layer.
TetMesh strip_and_block(const MembraneSetup& setup) {
  const reference::MembraneProblem string = first_string(setup);
  const Eigen::Vector3i cells(setup.cells_along + kBlockCells, setup.cells_across, kLayers);
  const Vec3 half = 0.5 * cells.cast<double>();
  const TetMesh lattice = reference::box_mesh(cells.cast<double>(), cells);
  const double thick = 0.5 * setup.thickness, high = 0.5 * setup.block_height;
  const std::array<double, kLayers + 1> level{-high, -0.5 * (high + thick), -thick,
                                              thick, 0.5 * (high + thick),  high};
  const auto place = [&](const Vec3& p) {
    const double i = p.x() + half.x();
    const double x =
        i <= setup.cells_along
            ? setup.length * i / setup.cells_along
            : setup.length + setup.block_length * (i - setup.cells_along) / kBlockCells;
    const double down = x < setup.length ? sag(string, x) : 0.0;
    const auto k = static_cast<std::size_t>(std::lround(p.z() + half.z()));
    return Vec3(x, setup.width * p.y() / setup.cells_across, level[k] - down);
  };
  TetMesh mesh;
  mesh.tetrahedra.resize(4, lattice.tetrahedra.cols());
  std::vector<int> number(static_cast<std::size_t>(lattice.vertices.cols()), -1);
  std::vector<Vec3> vertices;
  Eigen::Index kept = 0;
  for (Eigen::Index e = 0; e < lattice.tetrahedra.cols(); ++e) {
    Vec3 centre = half;
    for (int k = 0; k < 4; ++k) centre += 0.25 * lattice.vertices.col(lattice.tetrahedra(k, e));
    if (centre.x() < setup.cells_along && static_cast<int>(centre.z()) != kMiddle) continue;
    for (int k = 0; k < 4; ++k) {
      int& v = number[static_cast<std::size_t>(lattice.tetrahedra(k, e))];
      if (v < 0) {
        v = static_cast<int>(vertices.size());
        vertices.push_back(place(lattice.vertices.col(lattice.tetrahedra(k, e))));
      }
      mesh.tetrahedra(k, kept) = v;
    }
    ++kept;
  }
  mesh.tetrahedra.conservativeResize(4, kept);
  mesh.vertices.resize(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    mesh.vertices.col(static_cast<Eigen::Index>(v)) = vertices[v];
  }
  return mesh;
}

Vec3 gravity_on(double tan_slope) {
  const double slope = std::atan(tan_slope);
  return kStandardGravity * Vec3(std::sin(slope), 0.0, -std::cos(slope));
}

double strip_mass(const MembraneSetup& setup) {
  return setup.density * setup.length * setup.width * setup.thickness;
}

double block_mass(const MembraneSetup& setup) {
  return setup.density * setup.block_length * setup.width * setup.block_height;
}

}  // namespace

reference::MembraneProblem membrane_string(const MembraneSetup& setup) {
  const Vec3 gravity = gravity_on(setup.tan_slope);
  return {.tension = (block_mass(setup) + 0.5 * strip_mass(setup)) * gravity.x(),
          .length = setup.length,
          .own_load = -strip_mass(setup) / setup.length * gravity.z(),
          .box_load = -setup.box_mass * gravity.z(),
          .gravity = kStandardGravity,
          .slope = std::atan(setup.tan_slope),
          .friction = setup.friction,
          .start = setup.start};
}

Problem membrane_problem(const MembraneSetup& setup) {
  const reference::MembraneProblem string = first_string(setup);
  const Elasticity elasticity{
      .youngs_modulus = setup.modulus, .poisson_ratio = 0.3, .damping_time = 1e-5};
  ProblemBody membrane{.name = "membrane",
                       .shape = MeshShape{strip_and_block(setup)},
                       .mass = strip_mass(setup) + block_mass(setup),
                       .elasticity = elasticity};
  membrane.held = HeldPart{Vec3::Zero(), Vec3::UnitX()};

  // The strip bends most under the box, whose lower edges therefore bear: it starts a hair above.
  const double half = 0.5 * setup.box_size.x();
  const double rise =
      sag(string, setup.start - half) - sag(string, setup.start + half);  // over the box, m
  const double tilt = std::atan(rise / setup.box_size.x());
  const double low = 0.5 * (sag(string, setup.start - half) + sag(string, setup.start + half));
  ProblemBody box{.name = "box",
                  .shape = BoxShape{setup.box_size},
                  .mass = setup.box_mass,
                  .elasticity = {.youngs_modulus = 5e5, .poisson_ratio = 0.3, .damping_time = 1e-3},
                  .position = Vec3(setup.start, 0.0,
                                   0.5 * (setup.thickness + setup.box_size.z()) - low + 1e-5)};
  box.rotation = Eigen::AngleAxisd(-tilt, Vec3::UnitY());
  Problem problem;
  problem.name = "inclined membrane";
  problem.bodies = {membrane, box};
  problem.obstacles = {
      {.name = "rail", .point = Vec3(0.0, 0.0, -0.5 * setup.block_height - 1e-6), .friction = 0.0}};
  problem.friction = setup.friction;
  problem.drag = setup.drag;
  problem.gravity = {
      {0.0, kMembraneLoaded, kMembraneTilted},
      {Vec3::Zero(), gravity_on(kMembraneFirstTangent), gravity_on(setup.tan_slope)}};
  problem.duration = 5.2;
  return problem;
}

}  // namespace stiction
