// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/motion/incline.h"
#include "validation/estimate/convergence.h"
#include "validation/protocols/incline_run.h"
#include "validation/protocols/incline_threshold.h"

namespace stiction {

namespace {

constexpr double kRelativeWidth = 1e-8;

void run_threshold(CaseRun& run, const InclineSetup& setup) {
  const double mu = setup.friction;
  const Bracket bracket = incline_threshold(run, setup, kRelativeWidth * mu);
  run.check({.quantity = "critical tan θ",
             .unit = "1",
             .statement = "the threshold does not depend on the integration scheme",
             .formula = "tan θ_c = μ",
             .source = "[Lazarevych2009], sec. 6",
             .kind = ReferenceKind::kAnalytic,
             .expected = mu,
             .relative = true,
             .tolerance = kRelativeWidth,
             .reason = "as in incline/threshold"},
            bracket.middle());
}

// Stopping distance of a point mass whose last step is cut at a generic place.
void run_stop(CaseRun& run, InclineSetup setup) {
  if (run.settings().contains("dt")) {
    throw NotApplicable("it compares time steps, of which a set dt leaves one");
  }
  setup.shape = PointShape{};
  setup.speed = 1.0;
  setup.tan_slope = 0.3;
  const reference::Incline incline{std::atan(setup.tan_slope), setup.friction, kStandardGravity};
  const double expected = reference::stopping_distance(incline, setup.speed);
  const double time = reference::stopping_time(incline, setup.speed);
  const double deceleration = reference::deceleration(incline);
  struct Stop {
    double time_step, distance;  // s, m
  };
  const auto stop = [&](double dt) -> Stop {
    InclineRun stopping(run, setup, incline_problem(setup), {.time = dt});
    stopping.advance_to(1.1 * time);
    return {stopping.time_step(), stopping.travel()};
  };
  const double at_default_step = stop(2e-4).distance;
  // Steps of which the same fraction is left when it stops: the error then falls smoothly.
  Series error{"distance error", "m", "time step", "s", {}, {}};
  for (const double steps : {1000.0, 2000.0, 4000.0}) {
    const Stop one = stop(run.finer() * time / (run.finer() * steps + 0.25));
    error.x.push_back(one.time_step);
    error.y.push_back(std::abs(one.distance - expected));
  }
  run.check({.quantity = "stopping distance",
             .unit = "m",
             .statement = "with velocities in the middle of steps the bias v₀Δt/2 is gone",
             .formula = "d = v₀²/(2g(μ cos θ − sin θ))",
             .source = "Coulomb's law; Störmer–Verlet",
             .kind = ReferenceKind::kAnalytic,
             .expected = expected,
             .relative = true,
             .tolerance = 0.125 * deceleration * 2e-4 * 2e-4 / expected,
             .reason = "the step in which it stops: at most aΔt²/8"},
            at_default_step);
  constexpr double kRounding = 1e-13;  // m
  const Claim order{.quantity = "order in Δt of the stopping distance",
                    .unit = "1",
                    .statement = "positions are of second order",
                    .formula = "error ≤ aΔt²/8",
                    .source = "Störmer–Verlet",
                    .kind = ReferenceKind::kAnalytic,
                    .expected = 2.0,
                    .tolerance = 0.01,
                    .reason =
                        "the error is a multiple of Δt² exactly; round-off of 1e-13 m is at "
                        "most a hundredth of the smallest"};
  if (*std::min_element(error.y.begin(), error.y.end()) < 100.0 * kRounding) {
    run.note("time steps are so fine that round-off hides the order");
    run.show(order, observed_order(error.x, error.y));
  } else {
    run.check(order, observed_order(error.x, error.y));
  }
  run.add(std::move(error));
}

}  // namespace

std::vector<Case> cases_incline_integrator() {
  InclineSetup setup;
  setup.azimuth = radians(30.0);
  setup.yaw = radians(20.0);
  const std::vector<Settings> verlet = {{{"integrator", "verlet"}}};
  return {{.name = "incline/integrator/threshold",
           .title = "critical slope with Störmer–Verlet in place of symplectic Euler",
           .variants = {{{"integrator", "verlet"}, {"rule", "fixed-point"}},
                        {{"integrator", "verlet"}, {"rule", "conjugate-vector"}}},
           .run = [setup](CaseRun& run) { run_threshold(run, setup); }},
          {.name = "incline/integrator/stop",
           .title = "stopping distance with Störmer–Verlet",
           .variants = verlet,
           .run = [setup](CaseRun& run) { run_stop(run, setup); }}};
}

}  // namespace stiction
