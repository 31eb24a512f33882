// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "reference/motion/incline.h"
#include "validation/protocols/incline_run.h"

namespace stiction {

namespace {

// Window in which the mean acceleration is read, s: vibrations of the landing have decayed.
constexpr double kFrom = 1.0, kTo = 2.0;

struct Sliding {
  double speed_before;
  double speed_after;
  double acceleration() const { return (speed_after - speed_before) / (kTo - kFrom); }
};

Sliding slide(CaseRun& run, const InclineSetup& setup) {
  InclineRun incline(run, setup, incline_problem(setup));
  InclineSeries series;
  advance_sampled(incline, kFrom, 100, series);
  const double before = incline.speed();
  advance_sampled(incline, kTo, 100, series);
  series.add_to(run);
  return {before, incline.speed()};
}

void run_above(CaseRun& run, const InclineSetup& setup) {
  const reference::Incline incline{std::atan(setup.tan_slope), setup.friction, kStandardGravity};
  const double expected = reference::sliding_acceleration(incline);
  const Sliding result = slide(run, setup);
  run.check({.quantity = "acceleration",
             .unit = "m/s²",
             .statement = "above the critical slope a box accelerates",
             .formula = "a = g(sin θ − μ cos θ)",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = expected,
             .relative = true,
             .tolerance = 1e-9,
             .reason = "a velocity grows by the same amount every step, so there is no truncation "
                       "error; contact vibrations have decayed below 1e-10 m/s in a 1 s window",
             .headline = "acceleration above the critical slope"},
            result.acceleration());
}

void run_critical(CaseRun& run, const InclineSetup& setup) {
  const Sliding result = slide(run, setup);
  run.check({.quantity = "speed after 1 s",
             .unit = "m/s",
             .statement = "at the critical slope a sliding box keeps its speed",
             .formula = "v(2 s) = v(1 s)",
             .source = "Coulomb's law; [Lazarevych2009], sec. 5",
             .kind = ReferenceKind::kAnalytic,
             .expected = result.speed_before,
             .relative = true,
             .tolerance = 1e-10,
             .reason = "no truncation error; vibrations have decayed below 1e-10 m/s"},
            result.speed_after);
  run.check({.quantity = "speed kept from the start",
             .unit = "m/s",
             .statement = "… and has lost none by landing under its weight",
             .formula = "v(1 s) = v₀",
             .source = "momentum balance: friction and weight act in the ratio μ",
             .kind = ReferenceKind::kAnalytic,
             .expected = setup.speed,
             .relative = true,
             .tolerance = 2.2e-7,
             .reason = "while the landing shakes the box for 0.1 s its contacts slip 1 mm/s across "
                       "the slope beside 1 m/s along it: friction, gμ cos θ = 4.4 m/s², loses half "
                       "the square of that angle, 4.4 · 5e-7 · 0.1 s = 2.2e-7 m/s"},
            result.speed_before);
}

}  // namespace

std::vector<Case> cases_incline_sliding() {
  InclineSetup above;
  above.azimuth = radians(30.0);
  above.yaw = radians(20.0);
  above.speed = 1.0;
  above.tan_slope = 1.2 * above.friction;
  InclineSetup critical = above;
  critical.tan_slope = critical.friction;
  InclineSetup point = above;
  point.shape = PointShape{};
  return {{.name = "incline/above/acceleration/box",
           .title = "a box accelerates at 1.2 × the critical slope",
           .set = CaseSet::kQuick,
           .run = [above](CaseRun& run) { run_above(run, above); }},
          {.name = "incline/above/acceleration/point",
           .title = "a point mass accelerates at 1.2 × the critical slope",
           .run = [point](CaseRun& run) { run_above(run, point); }},
          {.name = "incline/at-critical/speed",
           .title = "a box keeps its speed at the critical slope",
           .set = CaseSet::kQuick,
           .run = [critical](CaseRun& run) { run_critical(run, critical); }}};
}

}  // namespace stiction
