// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "benchmarks/workloads/workload.h"
#include "reference/meshes/box_mesh.h"

namespace stiction::bench {

namespace {

constexpr double kCell = 0.05;          // m
constexpr double kYoungsModulus = 2e5;  // Pa
constexpr double kDensity = 1000.0;     // kg/m³
constexpr double kSlope = 0.3;          // tan θ, at μ = 0.5

BodyDescription plate(const std::string& name, int cells) {
  BodyDescription body;
  body.name = name;
  body.mesh = reference::box_mesh({kCell * cells, kCell * cells, kCell}, {cells, cells, 1});
  body.material = {.density = kDensity,
                   .youngs_modulus = kYoungsModulus,
                   .poisson_ratio = 0.3,
                   .damping_time = 1e-3};
  return body;
}

// A plate of n × n cells on a larger one that is held below, turned so that the two meshes nowhere
// match: nearly all (n + 1)² vertices of the upper one touch, and as many of the lower one.
Setup make(int contacts) {
  const int n = std::max(2, static_cast<int>(std::lround(std::sqrt(0.5 * contacts))));
  BodyDescription upper = plate("upper", n);
  const Eigen::AngleAxisd turn(0.3, Vec3::UnitZ());
  upper.mesh.vertices =
      (turn.toRotationMatrix() * upper.mesh.vertices).colwise() + Vec3(0.013, 0.007, 0.5 * kCell);
  BodyDescription lower = plate("lower", static_cast<int>(std::ceil(1.3 * n)) + 1);
  lower.mesh.vertices.row(2).array() -= 0.5 * kCell;
  for (Eigen::Index v = 0; v < lower.mesh.vertices.cols(); ++v) {
    if (lower.mesh.vertices(2, v) < -0.9 * kCell) lower.pinned.push_back(static_cast<int>(v));
  }
  Setup setup;
  setup.description.bodies = {upper, lower};
  setup.description.friction = 0.5;
  setup.description.gravity = {{0.0}, {9.81 / std::hypot(1.0, kSlope) * Vec3(kSlope, 0.0, -1.0)}};
  // The upper plate as a mass on the shear spring of the lower one, a column of 1 m²:
  // ω² = G/h ÷ ρh.
  const double shear_modulus = kYoungsModulus / 2.6;
  setup.bounce = std::sqrt(shear_modulus / kDensity) / kCell;
  return setup;
}

}  // namespace

Family workload_slab() {
  return {.name = "slab",
          .title = "a deformable plate on a larger one, on a slope",
          .sizes = {100, 1000, 10000, 100000},
          .full_sizes = {1000000},
          .make = make};
}

}  // namespace stiction::bench
