// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "benchmarks/workloads/workload.h"
#include "reference/meshes/box_mesh.h"

namespace stiction::bench {

namespace {

constexpr int kRows = 4;
constexpr double kHeight = 0.05;        // of a brick, m; it is twice as long
constexpr double kYoungsModulus = 5e5;  // Pa
constexpr double kDensity = 1000.0;     // kg/m³

// A wall of four rows of bricks on the ground, in running bond with gaps between neighbours. It
// grows in length: its height, and with it the time to settle, stays. Rows are shifted a little, so
// that no vertex stands on an edge.
Setup make(int contacts) {
  // Contacts of a brick with the rows above and below, measured: 17.
  const int columns = std::max(2, static_cast<int>(std::lround(contacts / (17.0 * kRows))));
  BodyDescription brick;
  brick.mesh = reference::box_mesh({2.0 * kHeight, kHeight, kHeight}, {4, 2, 2});
  brick.material = {.density = kDensity,
                    .youngs_modulus = kYoungsModulus,
                    .poisson_ratio = 0.3,
                    .damping_time = 2e-4};
  Setup setup;
  for (int row = 0; row < kRows; ++row) {
    // Odd rows stand in the gaps, so no brick overhangs: one at the end would tip over.
    for (int column = 0; column < columns - row % 2; ++column) {
      BodyDescription body = brick;
      body.name = "brick " + std::to_string(row) + "/" + std::to_string(column);
      body.mesh.vertices.colwise() += kHeight * Vec3(2.1 * (column + 0.5 * (row % 2)) + 0.031 * row,
                                                     0.023 * (row % 2), 0.5 + row);
      setup.description.bodies.push_back(std::move(body));
    }
  }
  put_on_ground(0.5, setup);
  // A column of height H held below: quarter-wave π/2 √(E/ρ)/H; half of that, because bricks rest
  // on half of their faces' vertices.
  setup.bounce = 0.25 * M_PI * std::sqrt(kYoungsModulus / kDensity) / (kRows * kHeight);
  return setup;
}

}  // namespace

WorkloadFamily workload_wall() {
  return {.name = "wall",
          .title = "a wall of bricks in running bond, four rows high",
          .sizes = {100, 1000, 10000, 100000},
          .full_sizes = {1000000},
          .make = make};
}

}  // namespace stiction::bench
