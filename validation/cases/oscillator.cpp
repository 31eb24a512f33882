// SPDX-License-Identifier: GPL-3.0-or-later
// A box on a spring with dry friction: drawn over the ground at a steady speed, and swinging out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "validation/core/case_run.h"
#include "validation/problems/oscillator_problem.h"

namespace stiction {

namespace {

const char* const kOscillatorSource =
    "Newton's and Coulomb's laws, μ static = kinetic: half-swings are sines";
constexpr double kShear = 3e-4;  // of an elastic box, and what its landing leaves, in terms of δ

// What any method of first order may be off: of an amplitude, in `radians` of its vibration. Beside
// that the load changes within a step, and so does the sign of friction: once more.
double first_order(double rate, double dt, double radians) { return rate * dt * (radians + 1.0); }

void run_drawn(CaseRun& run, const OscillatorSetup& setup) {
  const double rate = oscillator_rate(setup), delta = oscillator_offset(setup);
  const double speed = setup.drawn, slips = delta / speed;
  const double period = 2.0 * std::numbers::pi / rate;
  const Vec3 axis = oscillator_axis(setup);
  const auto simulation = run.simulate(oscillator_problem(setup));
  simulation->record_frames(0.02);
  const Engine& engine = simulation->engine();
  const double dt = engine.time_step();
  Series velocity{"velocity", "m/s", "time", "s", {}, {}};
  // Faster than this it has slipped; how long a slip takes to get so fast is known.
  constexpr double kSlips = 0.05;
  const double late = std::acos(1.0 - kSlips) / rate;
  double first = std::numeric_limits<double>::quiet_NaN(), fastest = 0.0, slowest = speed;
  double force = 0.0, before = 0.0, aside = 0.0;
  std::uint64_t counted = 0;
  while (simulation->time() < slips + 2.25 * period) {
    simulation->advance(1);
    const double time = simulation->time();
    const BodyMotion box = engine.body(0);
    const double now = box.velocity.dot(axis);
    if (std::isnan(first) && time > 0.5 * slips && now > kSlips * speed) {
      first = time - dt * (now - kSlips * speed) / std::max(now - before, 1e-300) - late;
    }
    before = now;
    fastest = std::max(fastest, now);
    aside = std::max(aside, (box.position - box.position.dot(axis) * axis).head<2>().norm());
    if (std::abs(time - slips - period) < 0.25 * period) slowest = std::min(slowest, now);
    if (time > slips && time <= slips + 2.0 * period) {
      force += setup.stiffness * (speed * time - box.position.dot(axis));
      ++counted;
    }
    if (engine.steps_done() % 20 == 0) {
      velocity.x.push_back(time);
      velocity.y.push_back(now);
    }
  }
  run.add(velocity);
  const double swing = first_order(rate, dt, 4.0 * std::numbers::pi);
  const Claim common{
      .source = kOscillatorSource, .kind = ReferenceKind::kAnalytic, .relative = true};
  Claim claim = common;
  claim.quantity = "time of the first slip";
  claim.unit = "s";
  claim.statement = "the box sticks until the spring pulls with μ m g";
  claim.formula = "t₁ = μ m g/(k V)";
  claim.expected = slips;
  claim.tolerance = 2.0 * dt / slips + kShear;
  claim.reason =
      "two steps: the load is a step old, and the start of the slip is counted back "
      "from a speed of 0.05 V; an elastic box shears by 3e-4 δ";
  run.check(claim, first);
  claim = common;
  claim.quantity = "greatest speed";
  claim.unit = "m/s";
  claim.statement = "the slip swings about the speed of the anchor";
  claim.formula = "v = V (1 − cos ω τ) ≤ 2 V";
  claim.expected = 2.0 * speed;
  claim.tolerance = swing + kShear * rate * delta / speed;
  claim.reason =
      "of first order: ω Δt a radian, over two periods; an elastic box starts 3e-4 δ off";
  run.check(claim, fastest);
  claim.quantity = "least speed between two swings";
  claim.statement = "… and just comes to rest between two swings";
  claim.formula = "v(2π/ω) = 0";
  claim.expected = 0.0;
  claim.scale = speed;
  run.check(claim, slowest);
  claim = common;
  claim.quantity = "mean force of the spring";
  claim.unit = "N";
  claim.statement = "over whole periods of slip the spring pulls with μ m g";
  claim.formula = "⟨k (V t − x)⟩ = μ m g";
  claim.expected = setup.stiffness * delta;
  claim.tolerance = (rate * dt + swing * swing) * speed / (rate * delta) + kShear;
  claim.reason =
      "the force swings by k V/ω about it: a step at the ends of two periods, a second "
      "order of what the swing is off; the box's shear";
  run.check(claim, force / static_cast<double>(counted));
  claim = common;
  claim.quantity = "farthest way aside";
  claim.unit = "m";
  claim.statement = "it stays on the spring's line";
  claim.formula = "x × k = 0";
  claim.expected = 0.0;
  claim.scale = delta;
  claim.tolerance = kShear;
  claim.reason = "an elastic box's mesh is not its own mirror image: its shear, 3e-4 δ";
  run.check(claim, aside);
}

void run_free(CaseRun& run, const OscillatorSetup& setup) {
  const double rate = oscillator_rate(setup), delta = oscillator_offset(setup);
  const Vec3 axis = oscillator_axis(setup);
  // Of the swings about ± δ.
  double left = setup.stretch, radius = 0.0, last = 0.0;
  int halves = 0;
  for (; std::abs(left) > 1.0; ++halves) {
    last = std::abs(left) - 1.0;
    radius += last;
    left = std::copysign(2.0, left) - left;
  }
  const double rests = halves * std::numbers::pi / rate;
  const auto simulation = run.simulate(oscillator_problem(setup));
  simulation->record_frames(0.02);
  const Engine& engine = simulation->engine();
  const double dt = engine.time_step();
  Series place{"stretch of the spring", "m", "time", "s", {}, {}};
  const auto stretch = [&] { return engine.body(0).position.dot(axis) + setup.stretch * delta; };
  double stops = std::numeric_limits<double>::quiet_NaN();  // when it was last fast
  const double slow = 0.05 * rate * delta;
  while (simulation->time() < rests + 1.0) {
    simulation->advance(1);
    if (std::abs(engine.body(0).velocity.dot(axis)) > slow) stops = simulation->time();
    if (engine.steps_done() % 20 != 0) continue;
    place.x.push_back(simulation->time());
    place.y.push_back(stretch());
  }
  const double rest = stretch();
  simulation->advance_to(simulation->time() + 2.0);
  run.add(place);
  const Claim common{
      .source = kOscillatorSource, .kind = ReferenceKind::kAnalytic, .relative = true};
  Claim claim = common;
  claim.quantity = "stretch at rest";
  claim.unit = "m";
  claim.statement = "each half-swing takes 2 μ m g/k, until friction holds a turning point";
  claim.formula = "|x| ← |x| − 2δ, until |x| ≤ δ";
  claim.expected = left * delta;
  claim.scale = delta;
  claim.tolerance = rate * dt * std::numbers::pi * radius + halves * kShear;
  claim.reason =
      "of first order: ω Δt of an amplitude a radian, over the half-swings; an elastic "
      "box's shear and landing, 3e-4 δ each";
  run.check(claim, rest);
  claim = common;
  claim.quantity = "time to rest";
  claim.unit = "s";
  claim.statement = "each half-swing lasts π/ω, whatever friction takes";
  claim.formula = "t = n π/ω";
  claim.expected = rests;
  // From 0.05 ω δ to rest, in a swing whose radius is known.
  const double end = std::asin(std::min(1.0, 0.05 / last)) / rate;
  claim.tolerance = (2.0 * halves * dt + 0.1 * end) / rests;
  claim.reason =
      "two steps a half-swing; a tenth of the time from 0.05 ω δ to rest, which is added";
  run.check(claim, stops + end);
  run.check({.quantity = "creep",
             .unit = "m/s",
             .statement = "… and there it stays: mean speed over 2 s",
             .formula = "v = 0",
             .source = kOscillatorSource,
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 2.0 / dt * 0.5 * std::numeric_limits<double>::epsilon() * setup.stretch *
                          delta / 2.0,
             .reason = "round-off: half a unit in the last place of a coordinate, every step"},
            (stretch() - rest) / 2.0);
}

}  // namespace

std::vector<Case> cases_oscillator() {
  OscillatorSetup drawn;
  drawn.drawn = 0.1;
  OscillatorSetup free;
  free.stretch = 5.3;
  return {{.name = "oscillator/stick-slip",
           .title = "a box drawn by a spring sticks, then slips in swings",
           .set = CaseSet::kQuick,
           .run = [=](CaseRun& run) { run_drawn(run, drawn); }},
          {.name = "oscillator/free",
           .title = "a box on a spring swings out by friction and stays",
           .set = CaseSet::kQuick,
           .run = [=](CaseRun& run) { run_free(run, free); }}};
}

}  // namespace stiction
