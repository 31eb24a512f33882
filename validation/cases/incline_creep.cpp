// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "validation/observe/observe.h"
#include "validation/protocols/incline_run.h"

namespace stiction {

namespace {

void run_creep(CaseRun& run, const InclineSetup& setup) {
  constexpr double kFrom = 2.0, kTo = 12.0;  // s, the peers' window
  InclineRun incline(run, setup, settled_incline_problem(setup));
  InclineSeries series;
  advance_sampled(incline, kFrom, 200, series);
  const double start_up = incline.travel();
  advance_sampled(incline, kTo, 100, series);
  const double drift = incline.travel() - start_up;
  series.add_to(run);

  const double steps = (kTo - kFrom) / incline.time_step();
  const double ulp = std::numeric_limits<double>::epsilon() * 0.1;  // of a coordinate, m
  run.check(
      {.quantity = "creep",
       .unit = "m/s",
       .statement = "a box at rest below the critical slope does not move: mean speed over 10 s",
       .formula = "v = 0",
       .source = "Coulomb's law; [Lazarevych2009] reports 1e-9",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .tolerance = steps * 0.5 * ulp / (kTo - kFrom),
       .reason = "round-off: half a unit in the last place of a coordinate, every step"},
      drift / (kTo - kFrom));
  run.check({.quantity = "drift",
             .unit = "m",
             .statement = "after settling it stays where it is",
             .formula = "x(12 s) − x(2 s) = 0",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = steps * 0.5 * ulp,
             .reason = "round-off: half a unit in the last place of a coordinate, every step"},
            drift);
  run.note(fmt::format("start-up slip while loaded: {:.3e} m", start_up));
  if (!incline.tells_contacts()) return;
  // A stuck contact's slip is what rounding its velocity leaves: f is rounded, and added to v*.
  run.check({.quantity = "fastest contact slip at the end",
             .unit = "m/s",
             .statement = "contacts that stick do not slip",
             .formula = "u = 0",
             .source = "[Lazarevych2009], (15)",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 1e-15,
             .reason = "round-off of g Δt = 2e-3 m/s: 4e-19, some hundred roundings of the forces "
                       "behind it, with a factor ten"},
            fastest_slip(incline.engine()));
}

}  // namespace

std::vector<Case> cases_incline_creep() {
  std::vector<Case> cases;
  for (const int percent : {50, 90, 99}) {
    InclineSetup setup;
    setup.azimuth = radians(30.0);
    setup.yaw = radians(20.0);
    setup.tan_slope = percent / 100.0 * setup.friction;
    cases.push_back(
        {.name = fmt::format("incline/below/creep/{}%", percent),
         .title = fmt::format("a box rests for 10 s at {} % of the critical slope", percent),
         .set = percent == 99 ? CaseSet::kQuick : CaseSet::kDefault,
         .run = [setup](CaseRun& run) { run_creep(run, setup); }});
  }
  return cases;
}

}  // namespace stiction
