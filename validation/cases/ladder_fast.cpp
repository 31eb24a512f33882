// SPDX-License-Identifier: GPL-3.0-or-later
// Fast bodies: thrown on a sheet, and spinning.
#include <cmath>
#include <limits>

#include "solver/demand.h"
#include "validation/observe/passage_watch.h"
#include "validation/problems/ladder_problem.h"
#include "validation/problems/sheet_problem.h"
#include "validation/stability/ladder.h"

namespace stiction {

namespace {

// Thrown so fast that it covers the share of the sheet's thickness in a step.
void run_throw(CaseRun& run, double share) {
  run.passages_are_noted();
  SheetSetup setup;
  setup.thickness = 5e-3;
  setup.backed = true;
  std::string words;
  bool through = false, told = false;
  try {
    double step = 0.0;
    {
      const auto slow = run.simulate(sheet_problem(setup));
      step = slow->engine().time_step();
    }
    setup.speed = share * setup.thickness / step;
    const Problem problem = sheet_problem(setup);
    PassageWatch watch(problem);
    const auto simulation = run.simulate(problem);
    simulation->record_frames(1e-3);
    const double end = 4.0 * (setup.edge + setup.gap) / setup.speed;
    for (int k = 1; k <= 200 && !through && !told; ++k) {
      simulation->advance_to(end * k / 200.0);
      watch.look(simulation->engine());
      told = !watch.found().empty();
      through = has_passed(simulation->engine(), setup);
    }
    if (told) run.note("seen by the watch: " + watch.found().front());
  } catch (const InputError& refusal) {
    told = true;
    run.note(std::string("refused in words: ") + refusal.what());
  }
  run.check({.quantity = "silent passages",
             .unit = "1",
             .statement = "what is thrown on a sheet does not pass through it in silence",
             .formula = "it is thrown back, or the engine refuses, or the watch reports",
             .source = "bodies do not pass through each other",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .scale = 1.0,
             .tolerance = 0.0,
             .reason = "a count"},
            through && !told ? 1.0 : 0.0);
  // Soft bodies carry waves at 14 m/s: what comes faster is not theirs to throw back.
  run.show({.quantity = "throws not stood",
            .unit = "1",
            .statement = "… but comes back",
            .formula = "count = 0",
            .source = "bodies do not pass through each other",
            .kind = ReferenceKind::kAnalytic,
            .expected = 0.0,
            .scale = 1.0,
            .tolerance = 1.0,
            .reason = "told, not claimed: it is one throw"},
           through || told ? 1.0 : 0.0);
}

// A stiff cube that spins freely: it stretches by ρ ω² r²/E, and keeps its angular momentum.
void run_spin(CaseRun& run, double spin) {
  LadderBox box;
  box.cells = 2;
  box.elasticity = {.youngs_modulus = 1e9, .poisson_ratio = 0.3, .damping_time = 1e-5};
  box.angular_velocity = spin * Vec3(1, 2, 3).normalized();
  Problem problem;
  problem.name = "spinning cube";
  problem.bodies = {ladder_body(box, "cube")};
  const auto simulation = run.simulate(problem);
  const Engine& engine = simulation->engine();
  const Vec3 before = engine.momenta().angular;
  const double energy = engine.kinetic_energy();
  simulation->record_frames(2e-3);
  constexpr double kEnd = 0.2;  // s
  std::string broken;
  try {
    simulation->advance_to(kEnd);
  } catch (const InputError& error) {
    broken = error.what();
    run.note(broken);
  }
  const double infinity = std::numeric_limits<double>::infinity();
  run.check({.quantity = "angular momentum, change",
             .unit = "1",
             .statement = "what spins freely keeps its angular momentum",
             .formula = "|L − L₀|/|L₀| = 0",
             .source = "conservation of angular momentum",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .scale = 1.0,
             .tolerance = 1e-9,
             .reason = "round-off of ten thousand steps, 1e-16 each, times the vibration that they "
                       "take up; inner forces act along no lever"},
            broken.empty() ? (engine.momenta().angular - before).norm() / before.norm() : infinity);
  const Energies after = engine.energies();
  run.check(
      {.quantity = "energy gained",
       .unit = "1",
       .statement = "… and gains no energy",
       .formula = "max(0, (K + E)/K₀ − 1) = 0",
       .source = "conservation of energy; strain damps",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .scale = 1.0,
       .tolerance = 1e-3,
       .reason = "symplectic Euler's energy swings by ωΔt, the spin's: 1e-5 s at 100 rad/s"},
      broken.empty() ? std::max(0.0, (after.kinetic + after.elastic) / energy - 1.0) : infinity);
}

}  // namespace

std::vector<Case> cases_ladder_fast() {
  std::vector<Case> all;
  append(all, {.name = "thrown",
               .parameter = "share",
               .words = "a cube thrown on a sheet, by such a share of its thickness in a step",
               .rungs = {0.01, 0.03, 0.1, 0.3, 1, 3, 10},
               .run = run_throw});
  append(all, {.name = "spin",
               .parameter = "omega",
               .words = "a cube spins by so many radians a second",
               .rungs = {1, 10, 100, 300, 1e3, 3e3, 1e4},
               .run = run_spin});
  return all;
}

}  // namespace stiction
