// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include "reference/motion/incline.h"
#include "validation/protocols/incline_run.h"
#include "validation/protocols/incline_threshold.h"

namespace stiction {

namespace {

// The cube with which other engines were measured: 0.2 m, 1 kg, 27 nodes, E = 5e5 Pa, ν = 0.3,
// μ = 0.5. It would topple at tan θ = 1. Tolerances are what this engine's own errors may add up
// to; the bar of being ahead of every deformable engine measured (1e-12 m/s, 1e-3°, 1e-6, 5e-4,
// 1e-3) is named behind each, and lies at or above it.
InclineSetup peer_box(double azimuth) {
  InclineSetup setup;
  setup.shape = BoxShape{Vec3::Constant(0.2)};
  setup.azimuth = radians(azimuth);
  return setup;
}

void run_peer_box(CaseRun& run, const InclineSetup& level) {
  const double mu = level.friction;
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  const double edge = std::get<BoxShape>(level.shape).size.z();
  const double density = level.mass / (edge * edge * edge);

  InclineSetup below = level;
  below.tan_slope = 0.9 * mu;
  InclineRun rest(run, below, settled_incline_problem(below));
  rest.advance_to(2.0);
  const double from = rest.travel();
  rest.advance_to(12.0);
  run.check({.quantity = "creep at 90 %",
             .unit = "m/s",
             .statement = "mean speed from 2 s to 12 s",
             .source = "peers: 4e-13 (Bullet FEM explicit) to 0.12 (Jolt soft)",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 0.5 * kUlp * edge / rest.time_step(),
             .reason = "round-off: half a unit in the last place of a coordinate of 0.2 m in each "
                       "step, all to one side (the bar: 1e-12)",
             .headline = "creep at 90 % of the critical slope"},
            (rest.travel() - from) / 10.0);

  constexpr double kWidth = 1e-8;  // of tan θ
  const Bracket bracket = incline_threshold(run, level, kWidth);
  run.check(
      {.quantity = "threshold error",
       .unit = "°",
       .statement = "critical angle − atan μ",
       .source = "peers: −0.028 (IPC, tight) to −10.8 (Bullet FEM implicit)",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .tolerance = kWidth / (1.0 + mu * mu) * 180.0 / std::numbers::pi,
       .reason = "half the bracket, and as much again for vibrations, as in incline/threshold "
                 "(the bar: 1e-3)"},
      (std::atan(bracket.middle()) - std::atan(mu)) * 180.0 / std::numbers::pi);

  InclineSetup above = level;
  above.tan_slope = 1.2 * mu;
  above.speed = 1.0;
  InclineRun slide(run, above, incline_problem(above));
  slide.advance_to(1.0);
  const double before = slide.speed();
  slide.advance_to(2.0);
  const double steps = 1.0 / slide.time_step();
  const reference::Incline steep{std::atan(above.tan_slope), mu, kStandardGravity};
  run.check({.quantity = "acceleration at 120 %",
             .unit = "m/s²",
             .statement = "a = g(sin θ − μ cos θ)",
             .source = "peers: −5e-7 (Bullet FEM explicit) to +69 %",
             .kind = ReferenceKind::kAnalytic,
             .expected = reference::sliding_acceleration(steep),
             .relative = true,
             .tolerance = steps * kUlp * slide.speed() / reference::sliding_acceleration(steep),
             .reason = "round-off: a unit in the last place of a velocity of 2.7 m/s in each step "
                       "of a second; the integrator is exact for a constant acceleration, and the "
                       "cube's vibration has decayed by e⁻⁴⁰ (the bar: 1e-6)"},
            slide.speed() - before);

  InclineSetup stop = level;
  stop.speed = 2.0;
  const double expected = stop.speed * stop.speed / (2.0 * mu * kStandardGravity);
  const auto stopping_distance = [&](double finer) {
    InclineRun stopping(run, stop, incline_problem(stop), {.finer = finer});
    stopping.advance_to(1.0);
    return stopping.travel();
  };
  const double dt = slide.time_step();
  const double coarse = stopping_distance(1.0);
  const double fine = stopping_distance(2.0);
  constexpr double kNodes = 27.0;
  const Cost cost = slide.engine().cost();
  run.note(
      fmt::format("CPU per node and simulated second: {:.2f} ms ({:.0f} steps a second; Bullet "
                  "FEM explicit needs 8 ms)",
                  1e3 * cost.cpu_seconds / kNodes / slide.time(), 1.0 / slide.time_step()));

  const Elasticity& elastic = level.elasticity;
  const double pressed = density * kStandardGravity * edge * edge / (2.0 * elastic.youngs_modulus);
  const double leaning = pressed * mu * 2.0 * (1.0 + elastic.poisson_ratio);
  const double lengths = 2.0 * (pressed + leaning);
  const std::string of_lengths = fmt::format(
      "it is pressed together by ρgh²/(2E) = {:.1e} m and leans by μρgh²/(2G) = {:.1e} m; "
      "together, "
      "doubled for its corners, {:.1e} m",
      pressed, leaning, lengths);
  run.check(
      {.quantity = "stopping distance, extrapolated in Δt",
       .unit = "m",
       .statement = "d = v²/(2μg)",
       .formula = "2 d(Δt/2) − d(Δt)",
       .source = "peers: −0.26 % (MuJoCo flex) to +182 %",
       .kind = ReferenceKind::kAnalytic,
       .expected = expected,
       .relative = true,
       .tolerance = lengths / expected,
       .reason = "the elastic cube's own lengths, of 0.41 m: " + of_lengths + " (the bar: 5e-4)"},
      2.0 * fine - coarse);
  run.check({.quantity = "stopping distance at the default step",
             .unit = "m",
             .statement = "d = v²/(2μg)",
             .source = "peers: −0.26 % (MuJoCo flex) to +182 %",
             .kind = ReferenceKind::kAnalytic,
             .expected = expected,
             .relative = true,
             .tolerance = mu * kStandardGravity * dt / stop.speed + lengths / expected,
             .reason = "a step more or less of travel at the start, aΔt/v₀, and the lengths above "
                       "(the bar: 1e-3)"},
            coarse);
}

}  // namespace

std::vector<Case> cases_incline_peer_box() {
  std::vector<Case> cases;
  for (const double azimuth : {0.0, 30.0, 45.0}) {
    const InclineSetup setup = peer_box(azimuth);
    cases.push_back({.name = fmt::format("incline/peer-box/azimuth={}", azimuth),
                     .title = "the cube with which other engines were measured",
                     .run = [setup](CaseRun& run) { run_peer_box(run, setup); }});
  }
  return cases;
}

}  // namespace stiction
