// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <random>

#include "benchmarks/workloads/workload.h"
#include "reference/meshes/ball_mesh.h"

namespace stiction::bench {

namespace {

constexpr double kRadius = 0.1;         // m
constexpr double kYoungsModulus = 2e4;  // Pa: soft, so that each patch has a few contacts
constexpr double kDensity = 1000.0;     // kg/m³

// Seeded turns, so that no two patches are alike; the library's distributions differ from compiler
// to compiler.
class Turns {
 public:
  Mat3 next() {
    const double a = uniform(), b = uniform(), c = uniform(), d = uniform();
    return Eigen::Quaterniond(a, b, c, d).normalized().toRotationMatrix();
  }

 private:
  double uniform() { return static_cast<double>(generator_()) / 2147483648.0 - 1.0; }
  std::mt19937 generator_{7};
};

// Two layers of balls on the ground: m × m in a square lattice, just touching, and (m − 1)² in the
// hollows between them.
Setup make(int contacts) {
  // Contacts of a ball of the upper layer and its share of the lower one, measured: 30.
  const int m = std::max(2, 1 + static_cast<int>(std::lround(std::sqrt(contacts / 30.0))));
  const TetMesh ball = reference::ball_mesh({.radius = kRadius, .frequency = 3});
  Turns turns;
  Setup setup;
  for (int layer = 0; layer < 2; ++layer) {
    for (int row = 0; row < m - layer; ++row) {
      for (int column = 0; column < m - layer; ++column) {
        BodyDescription body;
        body.name = "ball " + std::to_string(setup.description.bodies.size());
        const Vec3 centre =
            kRadius * Vec3(2.0 * column + layer, 2.0 * row + layer, 1.0 + std::sqrt(2.0) * layer);
        body.mesh.tetrahedra = ball.tetrahedra;
        body.mesh.vertices = (turns.next() * ball.vertices).colwise() + centre;
        body.material = {.density = kDensity,
                         .youngs_modulus = kYoungsModulus,
                         .poisson_ratio = 0.3,
                         .damping_time = 2e-3};
        setup.description.bodies.push_back(std::move(body));
      }
    }
  }
  put_on_ground(0.8, setup);
  // The two layers as a column held below: quarter-wave π/2 √(E/ρ)/H, H = (2 + √2) r; 0.4 of that,
  // because they rest on narrow patches. (Measured: the worst ball of 1e4 contacts is at rest to 0.003
  // of its weight; with 0.6 the drag ends too soon, and it trembles by 0.06.)
  setup.bounce =
      0.2 * M_PI * std::sqrt(kYoungsModulus / kDensity) / ((2.0 + std::sqrt(2.0)) * kRadius);
  return setup;
}

}  // namespace

WorkloadFamily workload_pile() {
  return {.name = "pile",
          .title = "two layers of balls, the upper ones in the hollows of the lower ones",
          .sizes = {100, 1000, 10000},
          .full_sizes = {100000},
          .make = make};
}

}  // namespace stiction::bench
