// SPDX-License-Identifier: GPL-3.0-or-later
// What the paper's (7) does when it is read literally.
#include <cmath>
#include <numbers>

#include "validation/core/case_run.h"
#include "validation/protocols/slope_search.h"

namespace stiction {

namespace {

double degrees(double angle) { return angle * 180.0 / std::numbers::pi; }

// With the bound |F_i| of the paper's (7), which is twice what the pair transmits.
void run_trap(CaseRun& run, const SlabSetup& flat) {
  const double expected = degrees(std::atan(2.0 * flat.friction));
  constexpr double kTrapWidth = 0.01;  // °
  const SlopeSearch found =
      search_slope(run, flat, expected, expected - 3.7 * kTrapWidth, kTrapWidth, kTrapWidth);
  run.check({.quantity = "critical slope",
             .unit = "°",
             .statement = "(7) with the force before it is halved makes a box stick up to 2μ",
             .formula = "θ_c = atan 2μ: the trap",
             .source = "Coulomb's law with twice the cone",
             .kind = ReferenceKind::kAnalytic,
             .expected = expected,
             .tolerance = 0.5 * kTrapWidth + 0.045,
             .reason = "half the bracket, and the lean of soft bodies, 0.0205° at μ (measured, "
                       "slab/threshold), which grows with the shear: twice at 2μ, and a tenth. Not "
                       "extrapolated, since only the factor of two is claimed"},
            found.bracket.middle());
}

}  // namespace

std::vector<Case> cases_slab_trap() {
  return {{.name = "slab/threshold/bound=literal",
           .title = "the 2μ trap: μ times the force before it is halved",
           .variants = {{{"method", "paper"}, {"bound", "literal"}}},
           .run = [](CaseRun& run) { run_trap(run, slab_of_slopes()); }}};
}

}  // namespace stiction
