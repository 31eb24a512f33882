// SPDX-License-Identifier: GPL-3.0-or-later
// A row of boxes between two jaws, held up by friction alone.
#include <fmt/format.h>

#include <cmath>

#include "validation/observe/observe.h"
#include "validation/protocols/clamp_threshold.h"

namespace stiction {

namespace {

// A long row sways slowly: stiffer boxes and a slower load than the single box's.
ClampSetup row(int boxes) {
  ClampSetup setup;
  setup.boxes = boxes;
  setup.elasticity = {.youngs_modulus = 5e5, .poisson_ratio = 0.0, .damping_time = 1.5e-3};
  setup.fall_full = 1.0;
  return setup;
}

void run_shear(CaseRun& run, const ClampSetup& setup) {
  constexpr double kEnd = 4.0;  // s
  const auto simulation = run.simulate(clamp_problem(setup));
  const Engine& engine = simulation->engine();
  ClampSeries series;
  const auto out = [&] { return std::abs(pose_of(engine, 0).height) > 0.5 * setup.width; };
  for (int k = 1; k <= 200 && !out(); ++k) {
    advance_sampled(*simulation, kEnd * k / 200, 1, series);
  }
  series.add_to(run);
  const double weight = setup.box_mass * setup.fall;
  const double force = clamp_force(engine, setup);
  // Forces of a box's two joints, up on it, and what its own momentum still changes.
  double worst_balance = 0.0, worst_shear = 0.0;
  int worst_box = 0, worst_joint = 0;
  double couple = 0.0;  // of the jaws' pressure centres, over the row's length, N
  const JointForce first = joint_force(engine, setup, 0);
  const JointForce last = joint_force(engine, setup, setup.boxes);
  if (last.across > first.across) {
    couple = force * (first.height - last.height) / (last.across - first.across);
  }
  std::string all;
  double before = 0.0;
  for (int j = 0; j <= setup.boxes; ++j) {
    // Up on the body right of the joint.
    const double shear = -joint_force(engine, setup, j).on_left.z();
    const double expected = weight * (0.5 * setup.boxes - j) - couple;
    const double error = std::abs(shear - expected);
    if (error > worst_shear) worst_shear = error, worst_joint = j;
    if (j > 0 && std::abs(before - shear - weight) > worst_balance) {
      worst_balance = std::abs(before - shear - weight);
      worst_box = j;
    }
    before = shear;
    all += fmt::format("{}{:+.4f} (mg(n/2 − j) = {:+.4f})", j == 0 ? "" : ", ", shear,
                       weight * (0.5 * setup.boxes - j));
  }
  const double rate = setup.box_mass * 1e-9 / simulation->engine().time_step();
  Claim shear{.quantity = "joint shear",
              .unit = "N",
              .statement = "each joint carries its share of the weight: worst joint's error",
              .formula = "V_j = mg(n/2 − j) − NΔh/L",
              .source = "balance of force and couple; Δh of the jaws' pressure centres as measured",
              .kind = ReferenceKind::kAnalytic,
              .expected = 0.0,
              .relative = true,
              .scale = weight,
              .tolerance = 1e-3,
              .reason =
                  "the row has sagged: its boxes' weights act up to 1e-3 of its length off "
                  "the places that the formula assumes"};
  run.check(shear, worst_shear, fmt::format("joint {}", worst_joint));
  Claim balance{.quantity = "weight carried",
                .unit = "N",
                .statement = "what its two joints carry is a box's weight: worst box's error",
                .formula = "V_(j−1) − V_j = mg",
                .source = "Newton's third law at rest",
                .kind = ReferenceKind::kAnalytic,
                .expected = 0.0,
                .tolerance = rate,
                .reason = "a box whose speed still changes by the paper's 1e-9 m/s in a step"};
  run.check(balance, worst_balance, fmt::format("box {}", worst_box));
  run.check({.quantity = "fastest contact slip",
             .unit = "m/s",
             .statement = "static contacts end with 1e-9 m/s",
             .formula = "u = 0",
             .source = "[Lazarevych2009], sec. 5",
             .kind = ReferenceKind::kExternal,
             .expected = 0.0,
             .tolerance = 1e-9,
             .reason = "the paper's own figure"},
            out() ? std::nan("") : fastest_slip(engine));
  run.note(fmt::format("N = {:.3f} N, {:.2f} × the least; shear by joint, N: {}", force,
                       force * 2.0 * setup.friction / (setup.boxes * weight), all));
}

}  // namespace

std::vector<Case> cases_box_row() {
  ClampSetup three = row(3);
  three.squeeze = 1.5e-3;
  const ClampSetup search = row(3);
  return {
      {.name = "clamp/row/shear/n=3",
       .title = "three boxes between jaws: what each joint carries",
       .run = [three](CaseRun& run) { run_shear(run, three); }},
      {.name = "clamp/row/threshold/n=3",
       .title = "least force that holds three boxes between jaws",
       .run = [search](CaseRun& run) { check_clamp_threshold(run, search, 1.5e-3, 0.5e-3, 2e-7); }},
      {.name = "clamp/row/threshold/n=3/half-step",
       .title = "least force that holds three boxes, at half the time step too",
       .set = CaseSet::kFull,
       .run = [search](CaseRun& run) {
         check_clamp_threshold(run, search, 1.5e-3, 0.5e-3, 2e-7, true);
       }}};
}

}  // namespace stiction
