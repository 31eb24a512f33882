// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "benchmarks/workloads/workload.h"
#include "reference/meshes/box_mesh.h"

namespace stiction::bench {

namespace {

constexpr int kStoreys = 4;
constexpr double kEdge = 0.05;          // of a cube, m
constexpr double kYoungsModulus = 5e5;  // Pa
constexpr double kDensity = 1000.0;     // kg/m³

// Towers of four cubes, each flush on the one below: every vertex in contact lies over a corner or an
// edge of the other mesh, where several faces are as near. The other families have their meshes shifted
// against each other, so that none does.
Setup make(int contacts) {
  // Of a tower, measured: 9 vertices a face, on both sides of three and on the ground, and edges that cross.
  const int towers = std::max(1, static_cast<int>(std::lround(contacts / 78.0)));
  BodyDescription cube;
  cube.mesh = reference::box_mesh({kEdge, kEdge, kEdge}, {2, 2, 2});
  cube.material = {.density = kDensity,
                   .youngs_modulus = kYoungsModulus,
                   .poisson_ratio = 0.3,
                   .damping_time = 2e-4};
  Setup setup;
  for (int tower = 0; tower < towers; ++tower) {
    for (int storey = 0; storey < kStoreys; ++storey) {
      BodyDescription body = cube;
      body.name = "cube " + std::to_string(tower) + "/" + std::to_string(storey);
      body.mesh.vertices.colwise() += kEdge * Vec3(1.5 * tower, 0.0, 0.5 + storey);
      setup.description.bodies.push_back(std::move(body));
    }
  }
  put_on_ground(0.5, setup);
  // A column of height H held below: quarter-wave π/2 √(E/ρ)/H.
  setup.bounce = 0.5 * M_PI * std::sqrt(kYoungsModulus / kDensity) / (kStoreys * kEdge);
  return setup;
}

}  // namespace

WorkloadFamily workload_flush() {
  return {.name = "flush",
          .title = "towers of four cubes, flush on each other",
          .sizes = {100, 1000, 10000},
          .full_sizes = {100000, 1000000},
          .make = make};
}

}  // namespace stiction::bench
