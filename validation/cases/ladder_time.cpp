// SPDX-License-Identifier: GPL-3.0-or-later
// What time does: steps from the longest to the shortest, damping down to nothing, a million steps.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "validation/observe/held_memory.h"
#include "validation/observe/observe.h"
#include "validation/problems/ladder_problem.h"
#include "validation/problems/slopes/incline_problem.h"
#include "validation/stability/ladder.h"

namespace stiction {

namespace {

InclineSetup flat_box(double tan_slope) {
  InclineSetup setup;
  setup.tan_slope = tan_slope;
  setup.friction = 0.5;
  setup.azimuth = 0.4;
  setup.yaw = 0.3;
  return setup;
}

// A box that is braked, then sticks: v = v₀ − a t, a = g (μ cos θ − sin θ), until v₀/a.
void run_step(CaseRun& run, double dt) {
  InclineSetup setup = flat_box(0.2);
  setup.speed = 0.1;
  const Problem problem = incline_problem(setup);
  const auto simulation = run.simulate(problem, {.fineness = 1, .time = dt});
  simulation->record_frames(0.01);
  const InclineFrame frame = incline_frame(setup);
  const double cosine = 1.0 / std::hypot(1.0, setup.tan_slope);
  const double braking = kStandardGravity * cosine * (setup.friction - setup.tan_slope);
  const double stop = setup.speed / braking;
  const Vec3 start = simulation->engine().body(0).position;
  simulation->advance_to(2.0 * stop);
  const BodyMotion end = simulation->engine().body(0);
  const double step = simulation->engine().time_step();
  const double expected = 0.5 * setup.speed * stop;
  // The box shears to its friction at once and swings about that: start-up slip, which no step mends.
  constexpr double kStartUp = 5e-3;
  run.check(
      {.quantity = "stopping distance",
       .unit = "m",
       .statement = "a box stops after the same way, however short the step",
       .formula = "v₀²/(2a)",
       .source = "Coulomb's law",
       .kind = ReferenceKind::kAnalytic,
       .expected = expected,
       .relative = true,
       .tolerance = step / stop + kStartUp,
       .reason = "of first order: v₀ Δt of v₀²/(2a), twice; the elastic box swings as the load "
                 "comes at once: ρ g h/E = 2e-3 of its height of 0.1 m, of the way of 1.3 mm"},
      frame.downhill.dot(end.position - start));
  run.check(
      {.quantity = "slip at the end",
       .unit = "m/s",
       .statement = "… and then sticks",
       .formula = "u = 0",
       .source = "Coulomb's law",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .scale = setup.speed,
       .tolerance = 1e-6 * setup.speed,
       .reason = "contacts of a fixed plane stick exactly once they stick; a swing that is left "
                 "keeps its contacts where they are"},
      slips_of(simulation->engine().contacts()).fastest);
}

void run_damping(CaseRun& run, double damping) {
  LadderBox box, slab;
  for (LadderBox* one : {&box, &slab}) {
    one->elasticity = {.youngs_modulus = 2e5, .poisson_ratio = 0.3, .damping_time = damping};
  }
  box.cells = 3;
  box.position = Vec3(0.004, -0.003, 0.0);
  box.rotation = Eigen::AngleAxisd(0.3, Vec3::UnitZ());
  slab.size = Vec3(0.2, 0.2, 0.05);
  slab.cells = 4;
  check_ladder_rest(run, ladder_problem(box_on_slab(box, slab), 0.5, 0.3),
                    "a box rests on a slab, however little they are damped");
}

constexpr std::uint64_t kWarm = 10000;  // steps, in which an engine takes what memory it needs

// What is held after kWarm steps and after so many more.
void check_memory(CaseRun& run, std::optional<std::int64_t> before,
                  std::optional<std::int64_t> after, std::uint64_t steps) {
  if (!before || !after) return run.note("memory: not applicable: nobody counts what is held");
  constexpr double kNumber = 8.0;  // bytes
  run.check({.quantity = "memory gained",
             .unit = "B",
             .statement = "… and needs no more memory for it",
             .formula = "max(0, held at the end − held after 1e4 steps) = 0",
             .source = "a step asks for no other than the one before it",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = kNumber / 32.0 * static_cast<double>(steps),
             .reason = "what is kept of a step is a number of 8 bytes at least, and one kept every "
                       "32 steps grows by that; 60 pages of 4 KiB, of which a process takes a "
                       "few when it is first looked at (where its heap is counted it is exact)"},
            std::max(0.0, static_cast<double>(*after - *before)));
}

// At rest from the first quarter on; then what moves is drift.
void run_steps(CaseRun& run, double steps) {
  InclineSetup setup = flat_box(0.3);
  const Problem problem = settled_incline_problem(setup, {0.02, 0.03, 0.07});
  const auto simulation = run.simulate(problem, {.fineness = 1});
  const auto all = static_cast<std::uint64_t>(steps);
  const bool watches_memory = all >= 100 * kWarm;
  std::optional<std::int64_t> held;
  if (watches_memory) {
    simulation->advance(kWarm);
    held = held_memory(simulation->engine());
  } else {
    simulation->record_frames(0.02);  // which takes memory, and looks alike on each rung
  }
  simulation->advance(all / 2 - simulation->engine().steps_done());
  const Vec3 half_way = simulation->engine().body(0).position;
  const Energies before = simulation->engine().energies();
  simulation->advance(all - all / 2);
  const std::optional<std::int64_t> held_at_end = held_memory(simulation->engine());
  const Energies after = simulation->engine().energies();
  const double drift = (simulation->engine().body(0).position - half_way).norm();
  constexpr double kStatic = 1e-9;                                                // m/s
  const double fall = setup.mass * kStandardGravity * longest_edge(setup.shape);  // J
  run.check({.quantity = "drift",
             .unit = "m",
             .statement = "what rests stays where it is for as many steps as one likes",
             .formula = "x(N) − x(N/2) = 0",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .scale = 0.2,
             .tolerance = 1e-9,
             .reason = "the paper's 1e-9 m/s over a second or more"},
            drift);
  run.check({.quantity = "energy gained",
             .unit = "J",
             .statement = "… and gains no energy",
             .formula = "max(0, K + E of the second half − of the first) = 0",
             .source = "nothing does work on what rests",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .scale = fall,
             .tolerance = 1e-9 * before.elastic + 0.5 * setup.mass * kStatic * kStatic,
             .reason = "the elastic energy, if it has any, swings down to its rest; round-off of "
                       "forty elements is 1e-14 of it; and what moves at the paper's 1e-9 m/s"},
            std::max(0.0, after.kinetic + after.elastic - before.kinetic - before.elastic));
  if (watches_memory) check_memory(run, held, held_at_end, all - kWarm);
}

}  // namespace

std::vector<Case> cases_ladder_time() {
  std::vector<Case> all;
  append(all, {.name = "time-step",
               .parameter = "dt",
               .words = "a box is braked and sticks with steps of so many seconds",
               .rungs = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7},
               .run = run_step});
  append(all, {.name = "damping",
               .parameter = "beta",
               .words = "a box on a slab rests within 2.5 s, damped by strain over so many seconds",
               .rungs = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 0},
               .run = run_damping});
  append(all, {.name = "steps",
               .parameter = "count",
               .words = "a box keeps its place for so many steps",
               .rungs = {1e4, 1e5, 1e6},
               .run = run_steps});
  return all;
}

}  // namespace stiction
