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
  // Two layers in shear, the lower one held below: a mass ρh where they meet and ρh/2 on top, each above a
  // spring G/h, all a square metre: ω² = (2 − √2) G/h ÷ ρh. (With the upper plate as one mass on the lower's
  // spring, which is faster, the drag ended too soon: it went on swinging by 0.03 of its weight.)
  const double shear_modulus =
      plates.elasticity.youngs_modulus / (2.0 * (1.0 + plates.elasticity.poisson_ratio));
  setup.bounce = std::sqrt((2.0 - std::sqrt(2.0)) * shear_modulus / plates.density) / kPlateCell;
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
