// SPDX-License-Identifier: GPL-3.0-or-later
// Four questions to any engine about the cube with which engines were measured side by side: 0.2 m,
// 1 kg, μ = 0.5, on slopes that fall in three directions, for friction made of a pyramid depends on
// that. Nothing is asked but motions, and no slope is taken for granted.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "reference/motion/incline.h"
#include "validation/estimate/threshold.h"
#include "validation/protocols/incline_run.h"
#include "validation/protocols/slope_gives.h"

namespace stiction {

namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();
constexpr double kDegrees = 180.0 / std::numbers::pi;

InclineSetup cube(double azimuth) {
  InclineSetup setup;
  setup.shape = BoxShape{Vec3::Constant(0.2)};
  setup.azimuth = radians(azimuth);
  return setup;
}

double edge(const InclineSetup& setup) { return std::get<BoxShape>(setup.shape).size.z(); }

void run_creep(CaseRun& run, InclineSetup setup) {
  setup.tan_slope = 0.9 * setup.friction;
  InclineRun rest(run, setup, settled_incline_problem(setup));
  rest.record_frames(0.2);
  rest.advance_to(2.0);
  const double first = rest.travel();
  rest.advance_to(7.0);
  const double half = rest.travel();
  rest.advance_to(12.0);
  const double last = rest.travel();
  run.check({.quantity = "creep",
             .unit = "m/s",
             .statement = "a box at 90 % of the critical slope does not move: mean speed from 2 s "
                          "to 12 s",
             .formula = "v = 0",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 0.5 * kUlp * edge(setup) / rest.time_step(),
             .reason = "round-off: half a unit in the last place of a coordinate of 0.2 m in each "
                       "step, all to one side"},
            (last - first) / 10.0);
  run.note(fmt::format("mean speed of the first half {:.3e} m/s, of the second {:.3e} m/s",
                       (half - first) / 5.0, (last - half) / 5.0));
}

void run_gives(CaseRun& run, const InclineSetup& setup) {
  constexpr double kWidth = 1e-5;  // of the bracket on tan θ, to μ
  const double expected = giving_slope(setup.friction);
  const Bracket bracket = slope_that_gives(run, setup, kWidth * setup.friction);
  run.check({.quantity = "slope that gives",
             .unit = "°",
             .statement = "the slope on which a box begins to accelerate",
             .formula = "tan θ = μ/(1 − 10⁻³), where it accelerates with 10⁻³ g sin θ",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = kDegrees * std::atan(expected),
             .tolerance = kDegrees * kWidth * expected / (1.0 + expected * expected),
             .reason = "half the bracket, and as much again for what still rings: 1e-5 of 1e-3 g "
                       "is 5e-8 m/s in the half second observed"},
            kDegrees * std::atan(bracket.middle()),
            fmt::format("holds at tan θ = {:.6g}, gives at {:.6g}", bracket.holds, bracket.fails));
}

void run_accelerates(CaseRun& run, InclineSetup setup) {
  setup.tan_slope = 1.2 * setup.friction;
  setup.speed = 1.0;
  InclineRun slide(run, setup, incline_problem(setup));
  slide.record_frames(0.05);
  slide.advance_to(1.0);
  const double from = slide.time(), before = slide.speed();
  slide.advance_to(2.0);
  const double seconds = slide.time() - from;
  const double expected = reference::sliding_acceleration(
      {std::atan(setup.tan_slope), setup.friction, kStandardGravity});
  run.check({.quantity = "acceleration",
             .unit = "m/s²",
             .statement = "at 120 % of the critical slope a box accelerates",
             .formula = "a = g(sin θ − μ cos θ)",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = expected,
             .relative = true,
             .tolerance = kUlp * slide.speed() / slide.time_step() / expected,
             .reason = "round-off: a unit in the last place of a velocity of 2.7 m/s in each step; "
                       "a consistent integrator is exact for a constant acceleration"},
            (slide.speed() - before) / seconds);
}

void run_stops(CaseRun& run, InclineSetup setup) {
  setup.speed = 2.0;
  const double expected =
      reference::stopping_distance({0.0, setup.friction, kStandardGravity}, setup.speed);
  InclineRun stopping(run, setup, incline_problem(setup));
  stopping.record_frames(0.02);
  stopping.advance_to(1.0);
  const double volume = std::pow(edge(setup), 3);
  const double pressed = setup.mass / volume * kStandardGravity * edge(setup) * edge(setup) /
                         (2.0 * setup.elasticity.youngs_modulus);
  const double leaning = pressed * setup.friction * 2.0 * (1.0 + setup.elasticity.poisson_ratio);
  run.check({.quantity = "stopping distance",
             .unit = "m",
             .statement = "on level ground a sliding box stops",
             .formula = "d = v²/(2 μ g)",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = expected,
             .relative = true,
             .tolerance = setup.friction * kStandardGravity * stopping.time_step() / setup.speed +
                          2.0 * (pressed + leaning) / expected,
             .reason = "a step more or less of travel at the start, μ g Δt/v, and for a body that "
                       "deforms the lengths by which its weight presses and friction shears it, "
                       "ρgh²/(2E) and μρgh²/(2G), doubled for its corners"},
            stopping.travel());
}

}  // namespace

std::vector<Case> cases_slope_box() {
  std::vector<Case> cases;
  const auto add = [&](const char* what, double azimuth, CaseSet set, std::string title,
                       void (*run_it)(CaseRun&, InclineSetup)) {
    const InclineSetup setup = cube(azimuth);
    cases.push_back({.name = fmt::format("slope/{}/azimuth={}", what, azimuth),
                     .title = std::move(title),
                     .set = set,
                     .run = [setup, run_it](CaseRun& run) { run_it(run, setup); }});
  };
  for (const double azimuth : {0.0, 30.0, 45.0}) {
    const std::string falling = fmt::format(" that falls to {}°", azimuth);
    add("creep", azimuth, CaseSet::kDefault, "a cube rests for 12 s on a slope" + falling,
        run_creep);
    add("gives", azimuth, CaseSet::kDefault, "the steepest slope that holds a cube," + falling,
        [](CaseRun& run, InclineSetup setup) { run_gives(run, setup); });
    add("accelerates", azimuth, CaseSet::kDefault, "a cube accelerates on a slope" + falling,
        run_accelerates);
    add("stops", azimuth, CaseSet::kDefault,
        fmt::format("a cube thrown to {}° stops on level ground", azimuth), run_stops);
  }
  return cases;
}

}  // namespace stiction
