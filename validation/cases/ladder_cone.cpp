// SPDX-License-Identifier: GPL-3.0-or-later
// Friction from nothing to more than anything, and loads up to the edge of its cone.
#include <cmath>

#include "validation/observe/observe.h"
#include "validation/problems/ladder_problem.h"
#include "validation/problems/slopes/incline_problem.h"
#include "validation/stability/ladder.h"

namespace stiction {

namespace {

// A box that is given no push: it stays below tan θ, and above it gains g (sin θ − μ cos θ) t.
void run_friction(CaseRun& run, double friction) {
  InclineSetup setup;
  setup.tan_slope = 0.2;
  setup.friction = friction;
  setup.azimuth = 0.4;
  setup.yaw = 0.3;
  const auto simulation = run.simulate(settled_incline_problem(setup), {.fineness = 1});
  simulation->record_frames(0.02);
  const SettledLoad load;
  const InclineFrame frame = incline_frame(setup);
  simulation->advance_to(load.tangential_full);
  const double begin = frame.downhill.dot(simulation->engine().body(0).velocity);
  const double begun = simulation->time();
  simulation->advance_to(load.tangential_full + 0.5);
  const double gained = frame.downhill.dot(simulation->engine().body(0).velocity) - begin;
  const double time = simulation->time() - begun;
  const double cosine = 1.0 / std::hypot(1.0, setup.tan_slope);
  const double expected =
      kStandardGravity * cosine * std::max(0.0, setup.tan_slope - friction) * time;
  const double fall = kStandardGravity * cosine * setup.tan_slope * time;
  run.check(
      {.quantity = "speed gained",
       .unit = "m/s",
       .statement = "a box slides by Coulomb's law, or stays, whatever μ is",
       .formula = "max(0, g (sin θ − μ cos θ)) t",
       .source = "Coulomb's law",
       .kind = ReferenceKind::kAnalytic,
       .expected = expected,
       .relative = true,
       .scale = fall,
       .tolerance = 1e-3,
       .reason = "the box still swings by the last of its ramp, ρ g h/E = 2e-3 of 0.1 m at its "
                 "lowest frequency of 50 Hz damped by half each period: 1e-4 m/s of 1 m/s; ten "
                 "times that"},
      gained);
  const double slip = slips_of(simulation->engine().contacts()).fastest;
  if (friction > setup.tan_slope) {
    run.check({.quantity = "fastest contact slip",
               .unit = "m/s",
               .statement = "what stays does not creep",
               .formula = "u = 0",
               .source = "Coulomb's law",
               .kind = ReferenceKind::kAnalytic,
               .expected = 0.0,
               .scale = fall,
               .tolerance = 1e-9,
               .reason = "the paper's 1e-9 m/s of static contacts"},
              slip);
  }
}

void run_load(CaseRun& run, double share) {
  constexpr double kFriction = 0.5;
  LadderBox box, slab;
  for (LadderBox* one : {&box, &slab}) {
    one->elasticity = {.youngs_modulus = 1e6, .poisson_ratio = 0.3, .damping_time = 1e-3};
  }
  box.size = Vec3(0.1, 0.1, 0.05);
  box.cells = 2;
  box.position = Vec3(0.004, -0.003, 0.0);
  box.rotation = Eigen::AngleAxisd(0.3, Vec3::UnitZ());
  slab.size = Vec3(0.2, 0.2, 0.05);
  slab.cells = 4;
  check_ladder_rest(run, ladder_problem(box_on_slab(box, slab), kFriction, share * kFriction),
                    "a box rests on a slab up to the edge of the cone");
}

}  // namespace

std::vector<Case> cases_ladder_cone() {
  std::vector<Case> all;
  append(all, {.name = "friction",
               .parameter = "mu",
               .words = "a box on a slope of 0.2 slides or stays with such a friction",
               .rungs = {0, 1e-6, 1e-3, 0.1, 0.199, 0.201, 1, 1e3, 1e6},
               .quick = {0.1, 0.201},
               .run = run_friction});
  append(all, {.name = "cone",
               .parameter = "load",
               .words = "a box rests on a slab under such a share of the load that slides it",
               .rungs = {0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999},
               .quick = {0.9},
               .run = run_load});
  return all;
}

}  // namespace stiction
