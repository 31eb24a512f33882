// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "benchmarks/workloads/workload.h"
#include "validation/engines/stiction/stiction_scene.h"
#include "validation/problems/piles/plates_problem.h"

namespace stiction::bench {

namespace {

Setup make(int contacts) {
  PlatesSetup plates;
  plates.cells = std::max(2, static_cast<int>(std::lround(std::sqrt(0.5 * contacts))));
  plates.tan_slope = 0.3;  // at μ = 0.5
  Setup setup;
  setup.description = scene_description(plates_problem(plates), {});
  // The upper plate as a mass on the shear spring of the lower one, a column of 1 m²:
  // ω² = G/h ÷ ρh.
  const double shear_modulus =
      plates.elasticity.youngs_modulus / (2.0 * (1.0 + plates.elasticity.poisson_ratio));
  setup.bounce = std::sqrt(shear_modulus / plates.density) / kPlateCell;
  return setup;
}

}  // namespace

WorkloadFamily workload_slab() {
  return {.name = "slab",
          .title = "a deformable plate on a larger one, on a slope",
          .sizes = {100, 1000, 10000, 100000},
          .full_sizes = {1000000},
          .make = make};
}

}  // namespace stiction::bench
