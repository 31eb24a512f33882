// SPDX-License-Identifier: GPL-3.0-or-later
// Two bodies that differ by decades: in mass, in stiffness, in size.
#include <algorithm>
#include <cmath>

#include "validation/problems/ladder_problem.h"
#include "validation/stability/ladder.h"

namespace stiction {

namespace {

constexpr double kViscosity = 1e3;  // Pa s: β · E

Elasticity stiffness(double youngs_modulus) {
  return {.youngs_modulus = youngs_modulus,
          .poisson_ratio = 0.3,
          .damping_time = kViscosity / youngs_modulus};
}

// A light box between the ground and a heavy one. All are as stiff as the heaviest needs for a strain of
// a hundredth, ρ g h/E.
void run_mass(CaseRun& run, double ratio) {
  LadderBox box;
  box.elasticity = stiffness(std::max(1e7, 1e5 * ratio));
  LadderBox slab = box;
  slab.size = Vec3(0.3, 0.3, 0.05);
  slab.cells = 3;
  std::vector<LadderBox> boxes = box_on_slab(box, slab);
  LadderBox top = boxes[1];
  top.density *= ratio;
  top.position.z() += top.size.z();
  boxes.push_back(top);
  check_ladder_rest(run, ladder_problem(boxes, kLadderFriction, kLadderTanSlope),
                    "a light box rests under a heavy one");
}

// Of the box over the slab: the softer of both has 1e5 Pa, a strain of a hundredth.
void run_stiffness(CaseRun& run, double ratio) {
  constexpr double kSofter = 1e5;  // Pa
  LadderBox box, slab;
  box.elasticity = stiffness(kSofter * std::max(ratio, 1.0));
  slab.elasticity = stiffness(kSofter * std::max(1.0 / ratio, 1.0));
  slab.size = Vec3(0.3, 0.3, 0.05);
  slab.cells = 4;
  box.cells = 2;
  box.position = Vec3(0.013, 0.007, 0.0);
  check_ladder_rest(run, ladder_problem(box_on_slab(box, slab), kLadderFriction, kLadderTanSlope),
                    "a box rests on a slab of another stiffness");
}

// The slab's edge over the box's: a small box stands within one triangle of a large one.
void run_size(CaseRun& run, double ratio) {
  LadderBox slab;
  slab.size = Vec3(1.0, 1.0, 0.25);
  slab.cells = 4;
  slab.elasticity = stiffness(1e6);
  LadderBox box;
  box.size = Vec3::Constant(1.0 / ratio);
  box.elasticity = stiffness(1e6);
  box.elasticity.damping_time *= 1.0 / ratio;  // as many periods of its own vibration
  box.position = Vec3(0.07, 0.03, 0.0);
  check_ladder_rest(run, ladder_problem(box_on_slab(box, slab), kLadderFriction, kLadderTanSlope),
                    "a small box rests on a large slab", box.size.x());
}

}  // namespace

std::vector<Case> cases_ladder_ratios() {
  std::vector<Case> all;
  append(all, {.name = "mass-ratio",
               .parameter = "top",
               .words = "a box rests under one so many times as heavy",
               .rungs = {1, 10, 100, 1e3, 1e4, 1e5, 1e6},
               .only_full = 1,
               .run = run_mass});
  append(all, {.name = "stiffness-ratio",
               .parameter = "box",
               .words = "a box rests on a slab, so many times as stiff as that",
               .rungs = {1e-4, 1e-2, 1, 1e2, 1e4, 1e6},
               .only_full = 1,
               .run = run_stiffness});
  append(all, {.name = "size-ratio",
               .parameter = "slab",
               .words = "a box rests on a slab that is so many times as wide",
               .rungs = {2, 10, 100, 1000},
               .run = run_size});
  return all;
}

}  // namespace stiction
