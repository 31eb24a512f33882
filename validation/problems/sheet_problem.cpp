// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/sheet_problem.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "reference/meshes/box_mesh.h"
#include "reference/meshes/rotation_onto.h"

namespace stiction {

namespace {

// Two layers of one lattice: the upper one whole, of the lower one the rim.
TetMesh drum(const SheetSetup& setup) {
  const int n = setup.cells;
  const Vec3 half(0.5 * n, 0.5 * n, 1.0);
  const TetMesh lattice = reference::box_mesh(2.0 * half, {n, n, 2});
  const std::array<double, 3> level{-setup.frame, 0.0, setup.thickness};
  std::vector<int> number(static_cast<std::size_t>(lattice.vertices.cols()), -1);
  std::vector<Vec3> vertices;
  TetMesh mesh;
  mesh.tetrahedra.resize(4, lattice.tetrahedra.cols());
  Eigen::Index kept = 0;
  for (Eigen::Index e = 0; e < lattice.tetrahedra.cols(); ++e) {
    Vec3 centre = half;
    for (int k = 0; k < 4; ++k) centre += 0.25 * lattice.vertices.col(lattice.tetrahedra(k, e));
    const bool on_rim =
        centre.x() < 1.0 || centre.x() > n - 1.0 || centre.y() < 1.0 || centre.y() > n - 1.0;
    if (centre.z() < 1.0 && !on_rim) continue;
    for (int k = 0; k < 4; ++k) {
      int& v = number[static_cast<std::size_t>(lattice.tetrahedra(k, e))];
      if (v < 0) {
        v = static_cast<int>(vertices.size());
        const Vec3 at = lattice.vertices.col(lattice.tetrahedra(k, e));
        vertices.emplace_back(setup.width * at.x() / n, setup.width * at.y() / n,
                              level[static_cast<std::size_t>(std::lround(at.z() + half.z()))]);
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

Eigen::Quaterniond turned(Stance stance) {
  const Eigen::AngleAxisd yaw(0.3, Vec3::UnitZ());
  const auto up = [&](const Vec3& what) {
    return yaw * reference::rotation_onto(what, Vec3::UnitZ());
  };
  if (stance == Stance::kFace) return up(Vec3::UnitZ());
  return up(stance == Stance::kEdge ? Vec3(0.0, 1.0, 1.0) : Vec3(1.0, 1.0, 1.0));
}

}  // namespace

Problem sheet_problem(const SheetSetup& setup) {
  constexpr double kDensity = 1000.0;  // kg/m³
  ProblemBody cube;
  cube.name = "cube";
  cube.shape = MeshShape{reference::box_mesh(Vec3::Constant(setup.edge), {2, 2, 2})};
  cube.mass = kDensity * std::pow(setup.edge, 3);
  cube.elasticity = setup.cube;
  // Off the middle and turned, so that no vertex meets one of the sheet's.
  cube.rotation = turned(setup.stance);
  const double reach = 0.5 * setup.edge * cube.rotation.toRotationMatrix().row(2).lpNorm<1>();
  cube.position = Vec3(0.007, 0.004, setup.thickness + setup.gap + reach);
  cube.velocity = Vec3(0.0, 0.0, -setup.speed);
  ProblemBody sheet;
  sheet.name = "sheet";
  const double inner = setup.width * (1.0 - 2.0 / setup.cells);
  sheet.mass = kDensity * (setup.width * setup.width * setup.thickness +
                           (setup.width * setup.width - inner * inner) * setup.frame);
  sheet.shape = MeshShape{drum(setup)};
  sheet.elasticity = setup.sheet;
  sheet.held = HeldPart{Vec3(0.0, 0.0, setup.backed ? 0.0 : -setup.frame), Vec3::UnitZ()};
  Problem problem;
  problem.name = "cube thrown on a sheet";
  problem.bodies = {cube, sheet};
  problem.friction = setup.friction;
  return problem;
}

bool has_passed(const Engine& engine, const SheetSetup& setup) {
  const Vec3 centre = engine.body(0).position;
  const Eigen::Matrix3Xi triangles = engine.surface(1);
  const Eigen::Matrix3Xd vertices = engine.vertices(1);
  bool above_one = false, any = false;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const Vec3 a = vertices.col(triangles(0, t));
    const Vec3 b = vertices.col(triangles(1, t));
    const Vec3 c = vertices.col(triangles(2, t));
    // Where the vertical through the centre meets the triangle: weights of b and c.
    Eigen::Matrix2d sides;
    sides << (b - a).head<2>(), (c - a).head<2>();
    if (sides.determinant() == 0.0) continue;
    const Eigen::Vector2d weights = sides.inverse() * (centre - a).head<2>();
    if (weights.minCoeff() < 0.0 || weights.sum() > 1.0) continue;
    any = true;
    const double height = a.z() + weights[0] * (b - a).z() + weights[1] * (c - a).z();
    above_one |= centre.z() > height;
  }
  // Beside the sheet it is through if it is beneath the frame.
  return any ? !above_one : centre.z() < -setup.frame;
}

}  // namespace stiction
