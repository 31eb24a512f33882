// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Small scenes for the unit tests of the solver.

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <string>
#include <utility>

#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/testing/test_refusal.h"

namespace stiction::test {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Of what a test tries again and again with other numbers it takes one in so many: a sanitizer, which watches the code
/// and not the numbers, takes ten times as long for each.
#ifdef STICTION_SANITIZES_MEMORY
inline constexpr std::size_t kOneIn = 7;  // no divisor of how often numbers come again
#else
inline constexpr std::size_t kOneIn = 1;
#endif

/// The corner tetrahedron (0, e₁, e₂, e₃) × edge.
inline TetMesh corner_tetrahedron(double edge = 1.0) {
  TetMesh mesh;
  mesh.vertices = Eigen::Matrix3Xd::Zero(3, 4);
  mesh.vertices.rightCols<3>().diagonal().setConstant(edge);
  mesh.tetrahedra = Eigen::Vector4i(0, 1, 2, 3);
  return mesh;
}

/// A box of so many cubic cells along each axis with a corner at the origin, each split into the six
/// tetrahedra along its diagonal (Kuhn). Vertices run along x first, then y, then z.
inline TetMesh grid_mesh(const Eigen::Vector3i& cells, double cell) {
  const Eigen::Vector3i points = cells.array() + 1;
  const auto vertex = [&](const Eigen::Vector3i& at) {
    return at.x() + points.x() * (at.y() + points.y() * at.z());
  };
  TetMesh mesh;
  mesh.vertices.resize(3, points.prod());
  mesh.tetrahedra.resize(4, 6 * cells.prod());
  Eigen::Index e = 0;
  for (int z = 0; z < points.z(); ++z) {
    for (int y = 0; y < points.y(); ++y) {
      for (int x = 0; x < points.x(); ++x) {
        const Eigen::Vector3i at(x, y, z);
        mesh.vertices.col(vertex(at)) = cell * at.cast<double>();
        if ((at.array() == cells.array()).any()) continue;
        std::array<int, 3> axes = {0, 1, 2};
        bool even = true;
        do {
          Eigen::Vector4i corners;
          Eigen::Vector3i corner = at;
          corners[0] = vertex(corner);
          for (int k = 0; k < 3; ++k) {
            ++corner[axes[static_cast<std::size_t>(k)]];
            corners[k + 1] = vertex(corner);
          }
          even = (axes[1] - axes[0] + 3) % 3 == 1;
          if (!even) std::swap(corners[2], corners[3]);
          mesh.tetrahedra.col(e++) = corners;
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
    }
  }
  return mesh;
}

/// The cube [0, edge]³ of n³ cells.
inline TetMesh cube_mesh(int n, double edge = 1.0) {
  return grid_mesh(Eigen::Vector3i::Constant(n), edge / n);
}

/// The cube [0, 1]³ of 3³ cells with a notch along y: without the cells of x in (⅓, ⅔), z > ⅓. Vertices that
/// were in these alone are left.
inline TetMesh notched_cube() {
  TetMesh mesh = cube_mesh(3);
  Eigen::Index kept = 0;
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int k = 0; k < 4; ++k) middle += 0.25 * mesh.vertices.col(mesh.tetrahedra(k, e));
    if (middle.z() > 1.0 / 3.0 && std::abs(middle.x() - 0.5) < 1.0 / 6.0) continue;
    mesh.tetrahedra.col(kept++) = mesh.tetrahedra.col(e);
  }
  mesh.tetrahedra.conservativeResize(4, kept);
  return mesh;
}

inline BodyDescription elastic_body(TetMesh mesh, const Material& material = {}) {
  BodyDescription body;
  body.name = "cube";
  body.mesh = std::move(mesh);
  body.material = material;
  body.point_mass = kNaN;  // unused: every vertex has a tetrahedron
  return body;
}

/// Point masses at `vertices`, m. Their order is kept by the numbering when it increases along x
/// and the points differ in nothing else.
inline BodyDescription point_masses(const Eigen::Matrix3Xd& vertices, double mass) {
  BodyDescription body;
  body.name = "points";
  body.mesh.vertices = vertices;
  body.material = {kNaN, kNaN, kNaN, kNaN};  // unused: nothing is elastic
  body.point_mass = mass;
  return body;
}

inline SceneDescription one_body(BodyDescription body) {
  SceneDescription description;
  description.bodies.push_back(std::move(body));
  return description;
}

/// The half-space z < 0.
inline HalfSpace ground(double friction) {
  return {"ground", Vec3::Zero(), Vec3::UnitZ(), friction};
}

/// Adds uniform noise of up to ± `amplitude` to each coordinate.
inline Eigen::Matrix3Xd noise(Eigen::Index count, double amplitude, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
  Eigen::Matrix3Xd values(3, count);
  for (double& value : values.reshaped()) value = uniform(generator);
  return values;
}

/// The scene's state at other positions and velocities; what no force law may read is NaN.
inline State state_at(const Scene& scene, const Eigen::Matrix3Xd& position,
                      const Eigen::Matrix3Xd& velocity) {
  State state = initial_state(scene);
  for (std::size_t k = 0; k < state.position.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    state.position[k] = {position.col(column), kNaN};
    state.velocity[k].v = velocity.col(column);
  }
  return state;
}

}  // namespace stiction::test
