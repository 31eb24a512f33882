// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "benchmarks/workloads/workload.h"
#include "reference/meshes/box_mesh.h"

namespace stiction::bench {

namespace {

constexpr double kCell = 0.01;          // m
constexpr double kYoungsModulus = 1e6;  // Pa
constexpr double kDensity = 1000.0;     // kg/m³

// A flat box of n × n × 1 cells on a plane at 90 % of the critical slope: (n + 1)² contacts.
Setup make(int contacts) {
  const int n = std::max(1, static_cast<int>(std::lround(std::sqrt(contacts))) - 1);
  BodyDescription body;
  body.name = "box";
  body.mesh = reference::box_mesh({n * kCell, n * kCell, kCell}, {n, n, 1});
  body.mesh.vertices.row(2).array() += 0.5 * kCell;
  body.material = {.density = kDensity,
                   .youngs_modulus = kYoungsModulus,
                   .poisson_ratio = 0.3,
                   .damping_time = 1e-5};
  Setup setup;
  setup.description.bodies = {body};
  setup.description.half_spaces = {{"plane", Vec3::Zero(), Vec3::UnitZ(), 0.5}};
  setup.description.gravity = {{0.0}, {Vec3(0.45 * 9.81, 0.0, -9.81)}};
  // Shear of the upper half of the masses on a layer of one cell: ω² = G/h ÷ ρh/2.
  setup.bounce = std::sqrt(2.0 * kYoungsModulus / 2.6 / kDensity) / kCell;
  return setup;
}

}  // namespace

WorkloadFamily workload_plane() {
  return {.name = "plane",
          .title = "a deformable box on a fixed plane, on a slope: one-sided contacts",
          .sizes = {100, 1000, 10000, 100000},
          .full_sizes = {1000000},
          .two_sided = false,
          .make = make};
}

}  // namespace stiction::bench
