// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "reference/incline.h"
#include "validation/incline_run.h"
#include "validation/incline_threshold.h"

namespace stiction {

namespace {

// The cube with which other engines were measured: 0.2 m, 1 kg, 27 nodes, E = 5e5 Pa, ν = 0.3,
// μ = 0.5. It would topple at tan θ = 1. Each figure's tolerance is the bar of being ahead of every
// deformable engine measured.
InclineSetup peer_box(double azimuth) {
  InclineSetup setup;
  setup.shape = BoxShape{Vec3::Constant(0.2)};
  setup.azimuth = radians(azimuth);
  return setup;
}

void run_peer_box(CaseRun& run, const InclineSetup& level) {
  const double mu = level.friction;

  InclineSetup below = level;
  below.tan_slope = 0.9 * mu;
  InclineRun rest(run, below, settled_incline_problem(below));
  rest.advance_to(2.0);
  const double from = rest.travel();
  rest.advance_to(12.0);
  run.check({.quantity = "creep at 90 %",
             .unit = "m/s",
             .claim = "mean speed from 2 s to 12 s",
             .source = "peers: 4e-13 (Bullet FEM explicit) to 0.12 (Jolt soft)",
             .kind = ReferenceKind::kAnalytic,
             .value = (rest.travel() - from) / 10.0,
             .expected = 0.0,
             .tolerance = 1e-12,
             .reason = "ahead of every deformable engine measured"});

  const Bracket bracket = incline_threshold(run, level, 1e-8);
  run.check({.quantity = "threshold error",
             .unit = "°",
             .claim = "critical angle − atan μ",
             .source = "peers: −0.028 (IPC, tight) to −10.8 (Bullet FEM implicit)",
             .kind = ReferenceKind::kAnalytic,
             .value = (std::atan(bracket.middle()) - std::atan(mu)) * 180.0 / std::numbers::pi,
             .expected = 0.0,
             .tolerance = 1e-3,
             .reason = "ahead of every deformable engine measured"});

  InclineSetup above = level;
  above.tan_slope = 1.2 * mu;
  above.speed = 1.0;
  InclineRun slide(run, above, incline_problem(above));
  slide.advance_to(1.0);
  const double before = slide.speed();
  slide.advance_to(2.0);
  const reference::Incline steep{std::atan(above.tan_slope), mu, kStandardGravity};
  run.check({.quantity = "acceleration at 120 %",
             .unit = "m/s²",
             .claim = "a = g(sin θ − μ cos θ)",
             .source = "peers: −5e-7 (Bullet FEM explicit) to +69 %",
             .kind = ReferenceKind::kAnalytic,
             .value = slide.speed() - before,
             .expected = reference::sliding_acceleration(steep),
             .relative = true,
             .tolerance = 1e-6,
             .reason = "ahead of every deformable engine measured"});

  InclineSetup stop = level;
  stop.speed = 2.0;
  const double expected = stop.speed * stop.speed / (2.0 * mu * kStandardGravity);
  const auto stopping_distance = [&](double dt) {
    InclineRun stopping(run, stop, incline_problem(stop), {{"dt", fmt::format("{}", dt)}});
    stopping.advance_to(1.0);
    return stopping.travel();
  };
  const double dt = slide.time_step();
  const double coarse = stopping_distance(dt);
  const double fine = stopping_distance(0.5 * dt);
  constexpr double kNodes = 27.0;
  const Cost cost = slide.engine().cost();
  run.note(
      fmt::format("CPU per node and simulated second: {:.2f} ms ({:.0f} steps a second; Bullet "
                  "FEM explicit needs 8 ms)",
                  1e3 * cost.cpu_seconds / kNodes / slide.time(), 1.0 / slide.time_step()));

  run.check({.quantity = "stopping distance, extrapolated in Δt",
             .unit = "m",
             .claim = "d = v²/(2μg)",
             .formula = "2 d(Δt/2) − d(Δt)",
             .source = "peers: −0.26 % (MuJoCo flex) to +182 %",
             .kind = ReferenceKind::kAnalytic,
             .value = 2.0 * fine - coarse,
             .expected = expected,
             .relative = true,
             .tolerance = 5e-4,
             .reason =
                 "the elastic cube's own lengths: it is pressed together by ρgh²/(2E) = 5e-5 m "
                 "and leans by mah/(2GA) = 6e-5 m; together, doubled for its corners, 2e-4 m "
                 "of 0.41 m"});
  run.check({.quantity = "stopping distance at the default step",
             .unit = "m",
             .claim = "d = v²/(2μg)",
             .source = "peers: −0.26 % (MuJoCo flex) to +182 %",
             .kind = ReferenceKind::kAnalytic,
             .value = coarse,
             .expected = expected,
             .relative = true,
             .tolerance = 1e-3,
             .reason = "half a step of travel, aΔt/v₀ = 5e-4, and the lengths above"});
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
