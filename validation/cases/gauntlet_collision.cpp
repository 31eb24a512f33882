// SPDX-License-Identifier: GPL-3.0-or-later
// Free bodies that meet tip on tip, ridge across ridge, ridge along ridge.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "validation/core/check_worst.h"
#include "validation/problems/gauntlet/tip_collision_problem.h"

namespace stiction {

namespace {

struct Collided {
  std::string words;
  double momentum = 0.0;  // largest change over Σ m|v|
  double energy = 0.0;    // at the end over that of the start
  double parting = 0.0;   // along z over the speed of approach
  double step = 0.0;      // s
  double sideways = 0.0;  // speed across z of either over its speed of approach
};

Collided collide(CaseRun& run, const TipCollisionSetup& setup, double finer) {
  const Problem problem = tip_collision_problem(setup);
  const auto simulation = run.simulate(problem, {.finer = finer});
  simulation->record_frames(1e-3);
  const Engine& engine = simulation->engine();
  const Vec3 start = engine.momenta().linear;
  const double energy = engine.kinetic_energy();
  Collided found;
  found.words = tip_collision_words(setup) + (finer > 1.0 ? ", half the step" : "");
  found.step = engine.time_step();
  double scale = 0.0;
  for (const ProblemBody& body : problem.bodies) scale += body.mass * body.velocity.norm();
  for (int k = 1; k <= 100; ++k) {
    simulation->advance_to(setup.duration * k / 100.0);
    found.momentum = std::max(found.momentum, (engine.momenta().linear - start).norm() / scale);
  }
  const Energies end = engine.energies();
  found.energy = (end.kinetic + end.elastic) / energy;
  const Vec3 lower = engine.body(0).velocity, upper = engine.body(1).velocity;
  found.parting = (upper - lower).z() / (2.0 * setup.speed);
  found.sideways = std::max(lower.head<2>().norm(), upper.head<2>().norm()) / setup.speed;
  return found;
}

void run_collisions(CaseRun& run, const std::vector<TipCollisionSetup>& setups) {
  std::vector<Collided> all, symmetric;
  for (const TipCollisionSetup& setup : setups) {
    for (const double finer : {1.0, 2.0}) {
      all.push_back(collide(run, setup, finer));
      if (setup.offset.isZero(0.0)) symmetric.push_back(all.back());
      const Collided& found = all.back();
      run.note(
          fmt::format("{}: parts at {:.4f} of the speed of approach, sideways {:.1e}, with "
                      "{:.4f} of the energy; momentum off by {:.1e}",
                      found.words, found.parting, found.sideways, found.energy, found.momentum));
    }
  }
  check_worst(
      run, all,
      {.quantity = "linear momentum, largest change",
       .unit = "1",
       .statement = "two free bodies keep their linear momentum when their tips meet",
       .formula = "|Σ m v(t) − Σ m v(0)| / Σ m|v(0)| = 0",
       .source = "Newton's third law",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .tolerance = 1e-12,
       .reason = "round-off: 3000 steps of some 40 vertices at 1e-16 of a vertex's momentum "
                 "give 1e-14, and two decades for the strong forces of the impact"},
      [](const Collided& c) { return c.momentum; });
  check_worst(run, all,
              {.quantity = "energy gained",
               .unit = "1",
               .statement = "… they end with no more energy than they had",
               .formula = "max(0, E(end)/E(0) − 1) = 0",
               .source = "energy balance: contact and damping only take",
               .kind = ReferenceKind::kAnalytic,
               .expected = 0.0,
               .tolerance = 1e-12,
               .reason = "an inequality; round-off"},
              [](const Collided& c) { return std::max(0.0, c.energy - 1.0); });
  check_worst(run, all,
              {.quantity = "speed of approach that is left",
               .unit = "1",
               .statement = "… they part again along the line on which they came",
               .formula = "max(0, −(v_upper − v_lower)·e_z / 2 v₀) = 0",
               .source = "a tip on a side steeper than its friction angle by no more than sticks",
               .kind = ReferenceKind::kAnalytic,
               .expected = 0.0,
               .tolerance = 0.0,
               .reason = "an inequality"},
              [](const Collided& c) { return std::max(0.0, -c.parting); });
  check_worst(
      run, symmetric,
      {.quantity = "sideways speed where they met in the middle",
       .unit = "1",
       .statement = "… and exactly along it where bodies and meeting are symmetric",
       .formula = "|v_xy| / v₀ = 0",
       .source = "symmetry under half a turn about z",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .tolerance = symmetric.front().step / 0.01,
       .reason = "which of several contacts comes first, and in which step, is not symmetric: a "
                 "step's share of an impulse that lasts 10 ms or longer"},
      [](const Collided& c) { return c.sideways; });
}

Case collision(const char* name, const char* title, const std::vector<TipCollisionSetup>& setups) {
  return {.name = name,
          .title = title,
          .set = CaseSet::kQuick,
          .suite = "stability",
          .run = [=](CaseRun& run) { run_collisions(run, setups); }};
}

}  // namespace

std::vector<Case> cases_gauntlet_collision() {
  return {
      collision(
          "gauntlet/spike-on-spike/thrown", "free spikes that meet tip on tip",
          {{}, {.yaw = 20.0}, {.offset = {1e-3, 0.0}}, {.offset = {1e-3, 0.5e-3}, .yaw = 20.0}}),
      collision("gauntlet/wedge-on-wedge/thrown", "free wedges that meet ridge on ridge",
                {{.ridges = true, .yaw = 90.0},
                 {.ridges = true, .yaw = 40.0},
                 {.ridges = true, .yaw = 10.0},
                 {.ridges = true, .yaw = 0.0},
                 {.ridges = true, .offset = {1e-3, 0.0}, .yaw = 0.0}})};
}

}  // namespace stiction
