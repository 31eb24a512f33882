// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "reference/motion/incline.h"
#include "validation/estimate/convergence.h"
#include "validation/protocols/incline_run.h"

namespace stiction {

namespace {

struct Stop {
  double distance;   // m
  double time;       // s
  double time_step;  // s
  bool symplectic_euler;
};

// Steps until the body no longer moves downhill, and a little longer, so that an elastic body has
// come back from its last shear.
Stop simulate_stop(CaseRun& run, const InclineSetup& setup, const Accuracy& accuracy,
                   double expected_time, InclineSeries* series) {
  InclineRun incline(run, setup, incline_problem(setup), accuracy);
  const double dt = incline.time_step();
  if (series) incline.record_frames(0.01);
  double stopped = std::numeric_limits<double>::quiet_NaN();
  // The stop itself is watched step by step; the way there in samples.
  if (series) {
    advance_sampled(incline, 0.99 * expected_time, 100, *series);
  } else {
    incline.advance_to(0.99 * expected_time);
  }
  const double last = 1.02 * expected_time + 20.0 * dt;
  while (incline.time() < last) {
    incline.advance_to(incline.time() + dt);
    if (series) series->sample(incline);
    if (std::isnan(stopped) && incline.speed() <= 1e-12) stopped = incline.time();
  }
  incline.advance_to(last + 0.3);
  return {incline.travel(), stopped, dt, incline.engine().symplectic_euler()};
}

// The relative truncation error is aΔt/v₀: the initial speed is chosen so that it stays below 1e-3.
InclineSetup sliding_setup(const Shape& shape, double tan_slope) {
  InclineSetup setup;
  setup.shape = shape;
  setup.tan_slope = tan_slope;
  setup.azimuth = radians(30.0);
  setup.speed = tan_slope == 0.0 ? 2.0 : 1.0;
  return setup;
}

// The stop at the case's own time step and what it should be.
struct Comparison {
  Stop stop;
  double distance;                // of a point mass, continuous, m
  double time;                    // …, s
  reference::DiscreteStop exact;  // of a point mass in steps of the same length
};

Comparison compare_stop(CaseRun& run, const InclineSetup& setup) {
  const reference::Incline incline{std::atan(setup.tan_slope), setup.friction, kStandardGravity};
  const double distance = reference::stopping_distance(incline, setup.speed);
  const double time = reference::stopping_time(incline, setup.speed);
  InclineSeries series;
  const Stop stop = simulate_stop(run, setup, {}, time, &series);
  series.add_to(run);
  return {stop, distance, time,
          reference::discrete_stop(setup.speed, reference::deceleration(incline), stop.time_step)};
}

// vₙ₊₁ = vₙ − aΔt, xₙ₊₁ = xₙ + Δt vₙ₊₁, to round-off.
void check_recurrence(CaseRun& run, const Comparison& comparison) {
  const auto& [stop, distance, time, exact] = comparison;
  // Each of the steps rounds x and v once: N ulp of the numbers involved.
  const double round_off = 4.0 * static_cast<double>(exact.steps) * 1.1e-16;
  run.check({.quantity = "stopping distance, discrete",
             .unit = "m",
             .statement = "a sliding point mass follows the exact recurrence of the time step",
             .formula = "vₙ₊₁ = vₙ − aΔt, xₙ₊₁ = xₙ + Δt vₙ₊₁, a = g(μ cos θ − sin θ)",
             .source = "reference/motion/incline.h",
             .kind = ReferenceKind::kExactComputed,
             .expected = exact.distance,
             .relative = true,
             .tolerance = round_off,
             .reason = "round-off: four roundings a step"},
            stop.distance);
  run.check({.quantity = "stopping time, discrete",
             .unit = "s",
             .statement = "it stops in the step in which the recurrence stops",
             .formula = "N = ⌈v₀/(aΔt)⌉",
             .source = "reference/motion/incline.h",
             .kind = ReferenceKind::kExactComputed,
             .expected = exact.time,
             .relative = true,
             .tolerance = round_off + (exact.whole_multiple ? stop.time_step / exact.time : 0.0),
             .reason = "round-off; one step more where v₀ is a whole multiple of aΔt"},
            stop.time);
}

// First order for symplectic Euler; another scheme may do better.
void check_order(CaseRun& run, const Stop& stop, double order, double tolerance,
                 const std::string& formula, const std::string& reason) {
  run.check(
      {.quantity = "order in Δt of the stopping distance",
       .unit = "1",
       .statement = stop.symplectic_euler ? "what depends on the step is of first order"
                                          : "what depends on the step is of first order or better",
       .formula = formula,
       .source = stop.symplectic_euler ? "symplectic Euler" : "a consistent scheme",
       .kind = ReferenceKind::kAnalytic,
       .expected = 1.0,
       .tolerance = tolerance,
       .reason = reason,
       .derived = true},
      stop.symplectic_euler ? order : std::min(order, 1.0));
}

void check_point_stop(CaseRun& run, const InclineSetup& setup) {
  const Comparison comparison = compare_stop(run, setup);
  const auto& [stop, distance, time, exact] = comparison;
  const double dt = stop.time_step;

  if (stop.symplectic_euler) check_recurrence(run, comparison);
  run.check({.quantity = "stopping distance",
             .unit = "m",
             .statement = "a sliding body stops after v₀²/(2a)",
             .formula = "d = v₀²/(2g(μ cos θ − sin θ))",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = distance,
             .relative = true,
             .tolerance = setup.speed * dt / distance,
             .reason = "symplectic Euler is biased by v₀Δt/2; twice that",
             .headline = "stopping distance of a sliding box"},
            stop.distance);
  run.check({.quantity = "stopping time",
             .unit = "s",
             .statement = "it stops after v₀/a",
             .formula = "t = v₀/(g(μ cos θ − sin θ))",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = time,
             .tolerance = dt,
             .reason = "a stop is seen at the end of its step"},
            stop.time);

  Series error{"distance error", "m", "time step", "s", {2.0 * dt, dt, 0.5 * dt, 0.25 * dt}, {}};
  for (const double step : error.x) {
    error.y.push_back(std::abs(
        simulate_stop(run, setup, {.finer = dt / step}, time, nullptr).distance - distance));
  }
  check_order(run, stop, observed_order(error.x, error.y), 0.02, "error ≈ v₀Δt/2",
              "the next term, aΔt²/8 at most, is 1e-4 of the first at the largest step; the "
              "position of the stop within its step adds as much");
  run.add(std::move(error));
}

void check_box_stop(CaseRun& run, const InclineSetup& setup) {
  const auto [stop, distance, time, exact] = compare_stop(run, setup);

  run.check(
      {.quantity = "stopping distance",
       .unit = "m",
       .statement = "a sliding elastic box stops after v₀²/(2a)",
       .formula = "d = v₀²/(2g(μ cos θ − sin θ))",
       .source = "Coulomb's law",
       .kind = ReferenceKind::kAnalytic,
       .expected = distance,
       .relative = true,
       .tolerance = setup.speed * stop.time_step / distance,
       .reason = "half a step of travel, v₀Δt/2, twice: the elastic box's own length scales below "
                 "are a fifth of the one at a step of 2e-4 s",
       .headline = "stopping distance of a sliding box"},
      stop.distance);
  // Weight presses the box together by ρgh²/(2E) at its centre, which costs μ times as much of
  // travel; when it stops, its centre leans by mah/(2GA).
  if (stop.symplectic_euler) {
    run.check(
        {.quantity = "stopping distance, discrete",
         .unit = "m",
         .statement = "the centre of mass follows the recurrence of a point mass",
         .formula = "vₙ₊₁ = vₙ − aΔt, xₙ₊₁ = xₙ + Δt vₙ₊₁",
         .source = "momentum balance; reference/motion/incline.h",
         .kind = ReferenceKind::kExactComputed,
         .expected = exact.distance,
         .tolerance = 4e-5,
         .reason = "elastic length scales of the box: μ·ρgh²/(2E) = 1.2e-5 m while it settles "
                   "under its weight, mah/(2GA) = 1.3e-5 m of shear let go when it stops, and "
                   "half as much again because corners carry more than the mean"},
        stop.distance);
  }

  std::vector<double> travel;
  for (const double finer : {1.0, 2.0, 4.0}) {
    travel.push_back(simulate_stop(run, setup, {.finer = finer}, time, nullptr).distance);
  }
  check_order(run, stop, std::log2((travel[0] - travel[1]) / (travel[1] - travel[2])), 0.1,
              "p = log₂((d(4h) − d(2h))/(d(2h) − d(h)))",
              "differences of 5e-5 and 2.5e-5 m, of which the phase of the vibration at the stop "
              "moves 1e-6 m");
}

Case stop_case(const std::string& name, const std::string& title, const Shape& shape,
               double tan_slope, CaseSet set) {
  const InclineSetup setup = sliding_setup(shape, tan_slope);
  const bool point = std::holds_alternative<PointShape>(shape);
  return {.name = name, .title = title, .set = set, .run = [setup, point](CaseRun& run) {
            point ? check_point_stop(run, setup) : check_box_stop(run, setup);
          }};
}

}  // namespace

std::vector<Case> cases_incline_below() {
  const Shape box = InclineSetup{}.shape;
  return {
      stop_case("incline/below/stop/point", "a sliding point mass stops, tan θ = 0.3 < μ = 0.5",
                PointShape{}, 0.3, CaseSet::kQuick),
      stop_case("incline/below/stop/box", "a sliding box stops, tan θ = 0.3 < μ = 0.5", box, 0.3,
                CaseSet::kDefault),
      stop_case("incline/level/stop/point", "a point mass stops on level ground, μ = 0.5",
                PointShape{}, 0.0, CaseSet::kDefault),
      stop_case("incline/level/stop/box", "a box stops on level ground, μ = 0.5", box, 0.0,
                CaseSet::kDefault),
  };
}

}  // namespace stiction
