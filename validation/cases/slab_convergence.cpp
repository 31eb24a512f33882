// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "validation/incline_run.h"
#include "validation/slab_problem.h"

namespace stiction {

namespace {

// A settled box at 20° whose contacts forget their friction for one step: no friction rule keeps
// what another remembered, so one step with the rule `none` empties the memory and leaves a slip.
// Nothing else is disturbed, so what follows is the friction iteration, and only behind it the
// elastic vibration that its first steps have set going.
void run_convergence(CaseRun& run, const SlabSetup& setup) {
  constexpr int kSteps = 2000;
  constexpr double kFound = 1e-9;  // m/s
  SlabRun settled(run, setup);
  settled.advance_to(4.0);
  const bool uses_none = run.settings().count("rule") && run.settings().at("rule") == "none";
  SlabRun forgetful(run, setup, {{"rule", uses_none ? "fixed-point" : "none"}, {"sweeps", "1"}});
  forgetful.engine().restore(settled.engine().save());
  forgetful.engine().advance(1);
  settled.engine().restore(forgetful.engine().save());

  Series slip{"fastest contact slip", "m/s", "step", "1", {}, {}};
  Series kinetic{"kinetic energy", "J", "step", "1", {}, {}};
  const double largest = forgetful.sample().fastest_slip;
  int reached = 0, last_above = 0;
  for (int k = 1; k <= kSteps; ++k) {
    settled.engine().advance(1);
    const SlabSample sample = settled.sample();
    if (k <= 100 || k % 20 == 0) {
      slip.x.push_back(k);
      slip.y.push_back(sample.fastest_slip);
      kinetic.x.push_back(k);
      kinetic.y.push_back(sample.kinetic);
    }
    if (sample.fastest_slip > kFound) last_above = k;
    if (sample.fastest_slip <= kFound && reached == 0) reached = k;
  }
  const double at_100 = slip.y[99];
  run.add(std::move(slip));
  run.add(std::move(kinetic));
  run.check({.quantity = "steps for the slip to fall from 1e-3 below 1e-9 m/s and stay there",
             .unit = "1",
             .claim = "static friction is found again within a hundred steps",
             .formula = "fastest |u| ≤ 1e-9 m/s",
             .source = "[Lazarevych2009], sec. 5: 1e-3 to 1e-9 m/s in 8–16 steps",
             .kind = ReferenceKind::kExternal,
             .value = last_above + 1.0,
             .expected = 0.0,
             .tolerance = 100.0,
             .reason = "the goal: at most a hundred steps"});
  run.note(fmt::format(
      "slip {:.2e} m/s when forgotten, {:.2e} after 100 steps; first below 1e-9 in step "
      "{} (0: never in {})",
      largest, at_100, reached, kSteps));
}

}  // namespace

std::vector<Case> cases_slab_convergence() {
  SlabSetup setup;
  setup.slope = radians(20.0);
  setup.yaw = radians(17.0);
  setup.offset = Vec3(0.013, 0.007, 0.0);
  setup.cells = 2;
  setup.slab_cells = 3;
  return {{.name = "slab/convergence",
           .title = "how fast static friction is found again",
           .set = CaseSet::kFull,
           .variants = {{{"method", "paper"}},
                        {{"method", "paper"}, {"rule", "secant"}},
                        {{"method", "quiet"}},
                        {{"method", "quiet"}, {"sweeps", "4"}},
                        {{"method", "quiet"}, {"sweeps", "16"}}},
           .run = [setup](CaseRun& run) { run_convergence(run, setup); }}};
}

}  // namespace stiction
