// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/motion/incline.h"
#include "validation/core/case_run.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

constexpr double kHeight = 0.1;  // m

Problem drop(const Shape& shape, double height, double duration) {
  InclineSetup setup;
  setup.shape = shape;
  setup.duration = duration;
  Problem problem = incline_problem(setup);
  problem.bodies[0].position.z() += height;
  return problem;
}

double total(const Energies& energies) {
  return energies.kinetic + energies.gravity + energies.elastic;
}

// xₙ = h − gΔt² n(n+1)/2 and vₙ = −gΔt n, to round-off.
void check_recurrence(CaseRun& run, const Engine& engine) {
  const auto steps = static_cast<std::int64_t>(engine.steps_done());
  const reference::PointState expected =
      reference::discrete_free_fall({kHeight, 0.0}, kStandardGravity, engine.time_step(), steps);
  const BodyMotion motion = engine.body(0);
  const double round_off = 4.0 * static_cast<double>(steps) * 1.1e-16;
  run.check({.quantity = "height after 0.1 s",
             .unit = "m",
             .statement = "without contact a point mass falls freely",
             .formula = "xₙ = h − gΔt² n(n+1)/2",
             .source = "symplectic Euler, reference/motion/incline.h",
             .kind = ReferenceKind::kExactComputed,
             .expected = expected.position,
             .relative = true,
             .tolerance = round_off,
             .reason = "round-off: four roundings a step"},
            motion.position.z());
  run.check({.quantity = "velocity after 0.1 s",
             .unit = "m/s",
             .statement = "… at the speed it must have",
             .formula = "vₙ = −gΔt n",
             .source = "symplectic Euler, reference/motion/incline.h",
             .kind = ReferenceKind::kExactComputed,
             .expected = expected.velocity,
             .relative = true,
             .tolerance = round_off,
             .reason = "round-off: four roundings a step"},
            motion.velocity.z());
}

// However an engine steps, it is off by no more than a step that takes a velocity at its wrong end.
void check_closed_form(CaseRun& run, const Simulation& simulation) {
  // A scheme may be off by all that is allowed; then round-off decides. Four roundings a step, of
  // 500 steps of 2e-4 s, are 2e-14 of 1e-4 m and 2e-13 of 1e-3 m/s: at most 2e-10 of each. Measured
  // with a leapfrog's velocity: 7e-12.
  constexpr double kRoundOff = 1e-9;  // of the tolerance
  const double time = simulation.time(), dt = simulation.engine().time_step();
  const BodyMotion motion = simulation.engine().body(0);
  run.check({.quantity = "height after 0.1 s, closed form",
             .unit = "m",
             .statement = "without contact a point mass falls freely",
             .formula = "x(t) = h − gt²/2",
             .source = "uniform acceleration",
             .kind = ReferenceKind::kAnalytic,
             .expected = kHeight - 0.5 * kStandardGravity * time * time,
             .tolerance = 0.5 * kStandardGravity * time * dt * (1.0 + kRoundOff),
             .reason = "a first-order scheme takes v at one end of each step: gtΔt/2 together"},
            motion.position.z());
  run.check({.quantity = "velocity after 0.1 s, closed form",
             .unit = "m/s",
             .statement = "… at the speed it must have",
             .formula = "v(t) = −gt",
             .source = "uniform acceleration",
             .kind = ReferenceKind::kAnalytic,
             .expected = -kStandardGravity * time,
             .tolerance = 0.5 * kStandardGravity * dt * (1.0 + kRoundOff),
             .reason = "a velocity may stand half a step beside its position, as a leapfrog's"},
            motion.velocity.z());
}

void run_free_fall(CaseRun& run) {
  const CaseRun::Running simulation = run.simulate(drop(PointShape{}, kHeight, 0.1));
  simulation->advance_to(0.1);
  if (simulation->engine().symplectic_euler()) {
    check_recurrence(run, simulation->engine());
  } else {
    check_closed_form(run, *simulation);
  }
}

void run_bounce(CaseRun& run) {
  const Problem problem = drop(PointShape{}, kHeight, 0.3);
  const CaseRun::Running simulation = run.simulate(problem);
  const double dt = simulation->engine().time_step();
  double rise = 0.0;
  double lowest = kHeight;
  double gain = 0.0;
  double energy = total(simulation->engine().energies());
  Series height{"height", "m", "time", "s", {}, {}};
  while (simulation->time() < problem.duration - 0.5 * dt) {
    simulation->advance_to(simulation->time() + dt);
    const Engine& engine = simulation->engine();
    rise = std::max(rise, engine.body(0).velocity.z());
    lowest = std::min(lowest, engine.body(0).position.z());
    const double now = total(engine.energies());
    gain = std::max(gain, now - energy);
    energy = now;
    if (engine.steps_done() % 10 == 0) {
      height.x.push_back(simulation->time());
      height.y.push_back(engine.body(0).position.z());
    }
  }
  run.add(std::move(height));
  const double round_off = 1e-15;
  run.check(
      {.quantity = "fastest rise",
       .unit = "m/s",
       .statement = "the half-space rule does not rebound: the whole depth is closed within a step",
       .formula = "F = m d/Δt² ends the step on the plane",
       .source = "[Lazarevych2009], (3), in the limit of a fixed obstacle",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .tolerance = round_off / dt,
       .reason = "round-off of a position on the plane, 1e-15 m, over one step"},
      rise);
  run.check({.quantity = "deepest penetration",
             .unit = "m",
             .statement = "at the end of a step nothing is inside the obstacle",
             .formula = "gap ≥ 0",
             .source = "Signorini",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = round_off,
             .reason = "round-off of a position on the plane"},
            std::min(0.0, lowest));
  run.check({.quantity = "largest energy gain in a step",
             .unit = "J",
             .statement = "contact never creates energy",
             .formula = "Eₙ₊₁ ≤ Eₙ (free fall loses ½mg²Δt² a step)",
             .source = "normal_force.h",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 1e-15,
             .reason = "round-off of 1 J"},
            gain);
  run.check({.quantity = "height at the end",
             .unit = "m",
             .statement = "it lies on the plane",
             .formula = "x = 0",
             .source = "Signorini",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = round_off,
             .reason = "round-off of a position on the plane"},
            simulation->engine().body(0).position.z());
}

void run_rest(CaseRun& run) {
  InclineSetup setup;
  const CaseRun::Running simulation = run.simulate(settled_incline_problem(setup));
  simulation->advance_to(1.0);
  const Engine& engine = simulation->engine();
  double normal_force = 0.0;
  double deepest = 0.0;
  for (const ContactSample& contact : engine.contacts()) {
    normal_force += contact.normal_force;
    deepest = std::min(deepest, contact.gap);
  }
  run.check(
      {.quantity = "sum of normal forces",
       .unit = "N",
       .statement = "a box at rest presses on the plane with its weight",
       .formula = "ΣN = mg",
       .source = "equilibrium",
       .kind = ReferenceKind::kAnalytic,
       .expected = setup.mass * kStandardGravity,
       .relative = true,
       .tolerance = 1e-9,
       .reason = "normal forces are depth · m/Δt² with depths of gΔt² = 4e-7 m beside "
                 "positions rounded to 1.4e-17 m: 4e-11 a contact, and a factor for the elastic "
                 "forces' round-off"},
      normal_force);
  run.check({.quantity = "kinetic energy",
             .unit = "J",
             .statement = "it is at rest",
             .formula = "½Σmv² = 0",
             .source = "equilibrium",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 1e-24,
             .reason = "the goal of the deformable cases: 1.4e-12 m/s for 1 kg"},
            engine.kinetic_energy());
  run.check({.quantity = "deepest penetration",
             .unit = "m",
             .statement = "nothing is inside the obstacle",
             .formula = "gap ≥ 0",
             .source = "Signorini",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 1e-15,
             .reason = "round-off of a position on the plane"},
            deepest);
}

void run_box_drop(CaseRun& run) {
  Problem problem = drop(InclineSetup{}.shape, 0.02, 1.0);
  problem.bodies[0].must_deform = true;
  const CaseRun::Running simulation = run.simulate(problem);
  const double dt = simulation->engine().time_step();
  const double start = total(simulation->engine().energies());
  double highest = start;
  Series series{"total energy", "J", "time", "s", {}, {}};
  while (simulation->time() < problem.duration - 0.5 * dt) {
    simulation->advance_to(simulation->time() + 5.0 * dt);
    const double energy = total(simulation->engine().energies());
    highest = std::max(highest, energy);
    series.x.push_back(simulation->time());
    series.y.push_back(energy);
  }
  run.add(std::move(series));
  const double kinetic_at_impact = 1.0 * kStandardGravity * 0.02;
  run.check({.quantity = "largest energy above the start",
             .unit = "J",
             .statement = "a falling, bouncing elastic box never has more energy than at the start",
             .formula = "E(t) ≤ E(0)",
             .source = "energy balance: contact, friction and damping only take",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .relative = true,
             .scale = kinetic_at_impact,
             .tolerance = 1e-14,
             .reason = "round-off; the integrator's own energy error has the sign of a loss"},
            highest - start);
}

}  // namespace

std::vector<Case> cases_half_space() {
  return {{.name = "half-space/free-fall",
           .title = "a point mass falls freely",
           .set = CaseSet::kQuick,
           .run = run_free_fall},
          {.name = "half-space/bounce",
           .title = "a point mass lands without rebound",
           .set = CaseSet::kQuick,
           .run = run_bounce},
          {.name = "half-space/rest", .title = "an elastic box at rest", .run = run_rest},
          {.name = "half-space/box-drop",
           .title = "an elastic box is dropped, bounces and never gains energy",
           .run = run_box_drop}};
}

}  // namespace stiction
