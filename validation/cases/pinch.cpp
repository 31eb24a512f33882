// SPDX-License-Identifier: GPL-3.0-or-later
// A small box hangs between two jaws by friction alone, as in a gripper's fingers.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

#include "validation/core/case_run.h"
#include "validation/estimate/threshold.h"
#include "validation/problems/pinch_problem.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

const char* const kPinchSource = "Coulomb's law and the balance of forces of body and jaws";

// Height of the body over the mean of the jaws', m.
double height(const Engine& engine) {
  return engine.body(0).position.z() -
         0.5 * (engine.body(1).position.z() + engine.body(2).position.z());
}

// The body's velocity over the jaws', upwards, m/s.
double rise(const Engine& engine) {
  return engine.body(0).velocity.z() -
         0.5 * (engine.body(1).velocity.z() + engine.body(2).velocity.z());
}

void run_hold(CaseRun& run, PinchSetup setup, double share) {
  constexpr double kFrom = 2.0, kTo = 12.0;  // s
  // What hangs still does so however its jaws lean: they may be so soft that a step is five times as
  // large. Softer ones still tremble at 2 s, by 2e-13 m at 5e5 Pa.
  setup.elasticity = Elasticity{.youngs_modulus = 2e6, .poisson_ratio = 0.3, .damping_time = 1e-4};
  setup.settled = 1.8;
  setup.force = share * least_pinch(setup);
  const auto simulation = run.simulate(pinch_problem(setup));
  simulation->record_frames(0.05);
  const Engine& engine = simulation->engine();
  Series fall{"height over the jaws", "m", "time", "s", {}, {}};
  const auto advance = [&](double end, int samples) {
    const double begin = simulation->time();
    for (int k = 1; k <= samples; ++k) {
      simulation->advance_to(begin + (end - begin) * k / samples);
      fall.x.push_back(simulation->time());
      fall.y.push_back(height(engine));
    }
  };
  advance(kFrom, 120);
  const double before = height(engine);
  const std::array<Vec3, 2> jaws{engine.body(1).position, engine.body(2).position};
  advance(kTo, 100);
  run.add(fall);

  const double steps = (kTo - kFrom) / engine.time_step();
  const double ulp = std::numeric_limits<double>::epsilon() * 0.5 * setup.jaw.z();  // of a height
  run.check({.quantity = "creep",
             .unit = "m/s",
             .statement = "what is held by friction does not sink: mean speed over 10 s",
             .formula = "v = 0 where 2 μ F ≥ m g",
             .source = kPinchSource,
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 2.0 * steps * 0.5 * ulp / (kTo - kFrom),
             .reason = "round-off: half a unit in the last place of a height every step, of the "
                       "body and of the jaws"},
            (height(engine) - before) / (kTo - kFrom));
  double moved = 0.0;
  for (const std::size_t jaw : {0, 1}) {
    moved = std::max(moved, (engine.body(jaw + 1).position - jaws[jaw]).norm());
  }
  run.check({.quantity = "drift of the jaws",
             .unit = "m",
             .statement = "… nor do the jaws move, which nothing but the body holds",
             .formula = "x(12 s) − x(2 s) = 0",
             .source = kPinchSource,
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 2.0 * steps * 0.5 * ulp,
             .reason = "round-off: half a unit in the last place of two coordinates every step; "
                       "what rounding the forces leaves of their sum, 1e-16 of 0.5 N, is far less"},
            moved);
  run.note(fmt::format("F = {:.4g} N, {:g} times the least; start-up slip {:.3e} m", setup.force,
                       share, -before));
}

// Means over the first moments in which the body is free.
struct PinchFall {
  double acceleration = 0.0;  // of the body over the jaws, downwards, m/s²
  double pressed = 0.0;       // what presses the body, in terms of F
};

// A jaw that gets faster has not passed its whole force on: N = F − M dv/dt. Sliding over a face
// shakes an elastic body by a millionth of a m/s, which is 1e-4 of F over the window.
PinchFall fall_of(CaseRun& run, const PinchSetup& setup) {
  constexpr double kWindow = 0.06;  // s
  const auto simulation = run.simulate(pinch_problem(setup));
  simulation->record_frames(0.01);
  simulation->advance_to(kPinchFree);
  const Engine& engine = simulation->engine();
  const double begin = simulation->time(), before = rise(engine);
  const auto closing = [&] {
    return (engine.body(1).velocity - engine.body(2).velocity).dot(pinch_across(setup));
  };
  const double closed = closing();
  simulation->advance_to(kPinchFree + kWindow);
  const double time = simulation->time() - begin;
  return {.acceleration = (before - rise(engine)) / time,
          .pressed = 1.0 - 0.5 * setup.jaw_mass * (closing() - closed) / time / setup.force};
}

// A jaw of height h and width w leans on elastic feet, by φ = C h/(E I): the couple C is that of the
// friction, m g w/4, and of the force where the body has come to be `fallen` (m) lower. Under the friction
// τ, as along a strip, its face slopes by σ = (1 + ν)(1 − 2ν) τ/E besides [Johnson1985, ch. 2]. Both faces
// then push the body down by F (φ + σ), in terms of its weight, with 2 μ F about m g (measured: with twice
// E half as much is missing):
double lean_share(const PinchSetup& setup, double fallen) {
  const Elasticity& jaw = setup.elasticity;
  const double weight = setup.mass * kStandardGravity;
  const double couple = 0.25 * weight * setup.jaw.x() + least_pinch(setup) * fallen;
  const double section = setup.jaw.y() * std::pow(setup.jaw.x(), 3) / 12.0;
  const double lean = couple * setup.jaw.z() / (jaw.youngs_modulus * section);
  const double shear = 0.5 * weight / (setup.edge * setup.edge);
  const double slope =
      (1.0 + jaw.poisson_ratio) * (1.0 - 2.0 * jaw.poisson_ratio) * shear / jaw.youngs_modulus;
  return (lean + slope) / setup.friction;
}

void run_slide(CaseRun& run, PinchSetup setup, double share) {
  constexpr double kFallen = 0.01;  // m, at the end of the window
  setup.force = share * least_pinch(setup);
  const PinchFall fall = fall_of(run, setup);
  run.check(
      {.quantity = "acceleration",
       .unit = "m/s²",
       .statement = "what friction does not hold falls with what is left of its weight",
       .formula = "a − 2 (μ M/m) dv/dt = g − 2 μ F/m, dv/dt of the jaws, inwards",
       .source = kPinchSource,
       .kind = ReferenceKind::kAnalytic,
       .expected = kStandardGravity * (1.0 - share),
       .relative = true,
       .tolerance = lean_share(setup, kFallen) / (1.0 - share),
       .reason = "a velocity grows by the same amount every step, so there is no truncation error; "
                 "elastic jaws lean by φ = (m g w/4 + F d) h/(E I), d = 1 cm fallen, their faces "
                 "slope by σ = (1 + ν)(1 − 2ν) τ/E, and they push by 2 F (φ + σ)"},
      fall.acceleration + kStandardGravity * share * (fall.pressed - 1.0));
  run.note(fmt::format("the jaws press with {:.6f} F", fall.pressed));
}

void run_threshold(CaseRun& run, PinchSetup setup) {
  constexpr double kGives = 1e-3;  // in terms of g: what falls faster does not hold
  constexpr double kWidth = 2e-5;  // of the bracket, to the least force
  const double least = least_pinch(setup);
  std::map<double, double> pressed;  // by F
  const auto holds = [&](double force) {
    setup.force = force;
    const PinchFall fall = fall_of(run, setup);
    pressed[force] = fall.pressed;
    const double excess = fall.acceleration - kGives * kStandardGravity;
    return Holding(excess < 0.0, excess);
  };
  // Begun where it falls, for that tells how far from the threshold it is.
  const Bracket bracket = find_threshold_near(0.963 * least, -0.05 * least, 0.6 * least,
                                              kWidth * least, holds, kStandardGravity / least);
  const double share = std::isnan(bracket.holds)
                           ? bracket.holds
                           : 0.5 * (pressed.at(bracket.holds) + pressed.at(bracket.fails));
  run.check(
      {.quantity = "least force",
       .unit = "N",
       .statement = "the body gives, that is falls faster than 1e-3 g, below a force",
       .formula = "N = (1 − 1e-3) m g/(2μ), N = F − M dv/dt",
       .source = kPinchSource,
       .kind = ReferenceKind::kAnalytic,
       .expected = (1.0 - kGives) * least,
       .relative = true,
       .tolerance = 0.5 * kWidth + lean_share(setup, 0.0),
       .reason =
           "half the bracket (1e-5), and the lean of elastic jaws and their faces, (φ + σ)/μ"},
      share * bracket.middle());
  run.note(
      fmt::format("F holds at {:.8g} N, gives at {:.8g} N, where the jaws press with {:.6f} F; "
                  "m g/(2μ) = {:.8g} N; {} runs",
                  bracket.holds, bracket.fails, share, least, bracket.evaluations));
}

}  // namespace

std::vector<Case> cases_pinch() {
  PinchSetup setup;
  PinchSetup turned = setup;  // no engine's friction pyramid lies along it
  turned.azimuth = std::numbers::pi / 6.0;
  return {{.name = "pinch/hold/150%",
           .title = "a body pinched with 1.5 × the least force hangs still for 10 s",
           .run = [=](CaseRun& run) { run_hold(run, setup, 1.5); }},
          {.name = "pinch/hold/150%/azimuth=30",
           .title = "… with everything turned by 30°",
           .set = CaseSet::kFull,
           .run = [=](CaseRun& run) { run_hold(run, turned, 1.5); }},
          {.name = "pinch/hold/105%",
           .title = "a body pinched with 1.05 × the least force hangs still for 10 s",
           .run = [=](CaseRun& run) { run_hold(run, setup, 1.05); }},
          {.name = "pinch/give/80%",
           .title = "a body pinched with 0.8 × the least force falls as it must",
           .run = [=](CaseRun& run) { run_slide(run, setup, 0.8); }},
          {.name = "pinch/threshold",
           .title = "least force that holds a pinched body",
           .run = [=](CaseRun& run) { run_threshold(run, setup); }}};
}

}  // namespace stiction
