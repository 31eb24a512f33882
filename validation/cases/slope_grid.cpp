// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "reference/motion/incline.h"
#include "validation/protocols/incline_run.h"
#include "validation/protocols/slope_gives.h"

namespace stiction {

namespace {

// One outcome for each μ and slope: on all that are flatter than Coulomb's it rests, on all that are
// steeper it gains speed.
void run_grid(CaseRun& run) {
  int pairs = 0, wrong = 0;
  double fastest = 0.0, largest = 0.0;
  std::string wrong_at, fastest_at, largest_at;
  double step = 1.0;
  for (int tenths = 1; tenths <= 10; ++tenths) {
    for (const double angle : {3.0, 8.0, 13.0, 18.0, 23.0, 28.0, 33.0, 38.0, 40.0}) {
      InclineSetup setup;
      setup.friction = tenths / 10.0;
      setup.tan_slope = std::tan(radians(angle));
      setup.azimuth = radians(15.0);
      const bool must_give = setup.tan_slope > giving_slope(setup.friction);
      const SlopeResponse seen = slope_response(run, setup);
      const std::string where = fmt::format("μ = {:.1f}, {}°", setup.friction, angle);
      ++pairs;
      if (seen.gives != must_give) {
        ++wrong;
        wrong_at += (wrong_at.empty() ? "" : "; ") + where + (must_give ? " holds" : " gives");
      }
      if (!must_give && !(std::abs(seen.speed) <= fastest)) {
        fastest = std::abs(seen.speed);
        fastest_at = where;
      }
      if (!must_give) continue;
      const double expected =
          reference::sliding_acceleration({radians(angle), setup.friction, kStandardGravity});
      const double error = std::abs(seen.acceleration / expected - 1.0);
      if (!(error <= largest)) {
        largest = error;
        largest_at = where;
        step = std::abs(seen.speed) / expected;
      }
    }
  }
  run.check(
      {.quantity = "wrong outcomes",
       .unit = "1",
       .statement = fmt::format("of {} pairs of μ and slope each holds or gives as it must", pairs),
       .formula = "gives if and only if tan θ > μ/(1 − 10⁻³)",
       .source = "Coulomb's law; the grid is that of a test of another engine, which allows "
                 "2° and 0.1 m/s",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .tolerance = 0.0,
       .reason = "yes or no: no pair lies within 0.1 % of the critical slope"},
      wrong, wrong_at);
  run.check(
      {.quantity = "fastest creep of those that must hold",
       .unit = "m/s",
       .statement = "what holds rests: mean speed over half a second",
       .formula = "v = 0",
       .source = "Coulomb's law",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .tolerance = 1e-11,
       .reason = "vibrations of the landing have decayed below 1e-11 m/s when it is looked at"},
      fastest, fastest_at);
  run.check({.quantity = "largest error of an acceleration",
             .unit = "1",
             .statement = "what gives accelerates with g(sin θ − μ cos θ)",
             .formula = "|a/a₀ − 1|",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 1e-6,
             .reason = "mean speeds of half a second each; what still rings, 1e-8 m/s beside the "
                       "least acceleration, 0.06 m/s²"},
            largest, fmt::format("{}; {:.2g} s of its acceleration", largest_at, step));
}

}  // namespace

std::vector<Case> cases_slope_grid() {
  return {{.name = "slope/grid",
           .title = "a flat box on slopes of 3 … 40° at μ = 0.1 … 1",
           .run = run_grid}};
}

}  // namespace stiction
