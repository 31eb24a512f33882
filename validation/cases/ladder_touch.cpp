// SPDX-License-Identifier: GPL-3.0-or-later
// Places where rounding alone would choose: features that coincide, planes that nearly do, gaps of nothing.
#include <algorithm>
#include <cmath>

#include "solver/demand.h"
#include "validation/observe/observe.h"
#include "validation/problems/ladder_problem.h"
#include "validation/problems/slopes/incline_problem.h"
#include "validation/stability/ladder.h"

namespace stiction {

namespace {

// Two equal boxes on a ground of the same width and mesh: vertex on vertex, edge on edge, diagonal on
// diagonal, but for what the upper ones are shifted by.
std::vector<LadderBox> flush_boxes(double shift) {
  LadderBox box;
  box.cells = 2;
  std::vector<LadderBox> boxes = box_on_slab(box, box);
  boxes[1].position += Vec3(shift, 0.0, 0.0);
  LadderBox upper = boxes[1];
  upper.position += Vec3(0.0, shift, upper.size.z());
  boxes.push_back(upper);
  return boxes;
}

void run_shift(CaseRun& run, double shift) {
  check_ladder_rest(run, ladder_problem(flush_boxes(shift), kLadderFriction, kLadderTanSlope),
                    "boxes on each other rest, whatever of them coincides");
}

// The lower edge of the tilted face touches first.
void run_tilt(CaseRun& run, double angle) {
  std::vector<LadderBox> boxes = flush_boxes(0.003);
  LadderBox& top = boxes.back();
  top.rotation = Eigen::AngleAxisd(angle, Vec3::UnitY());
  const double half = 0.5 * top.size.z();
  top.position.z() += half * (std::sin(angle) + std::cos(angle)) - half;
  check_ladder_rest(run, ladder_problem(boxes, kLadderFriction, kLadderTanSlope),
                    "faces that are parallel but for an angle come to lie on each other");
}

// Two boxes beside each other without weight, a gap apart that may be negative by rounding.
void run_gap(CaseRun& run, double gap) {
  LadderBox left, right;
  left.cells = right.cells = 2;
  right.position = Vec3(left.size.x() + gap, 0.0, 0.0);
  Problem problem;
  problem.name = "two boxes";
  problem.bodies = {ladder_body(left, "left"), ladder_body(right, "right")};
  problem.friction = kLadderFriction;
  const auto simulation = run.simulate(problem);
  simulation->record_frames(0.05);
  constexpr double kEnd = 0.5;  // s
  simulation->advance_to(kEnd);
  const Engine& engine = simulation->engine();
  const double apart = (engine.body(1).velocity - engine.body(0).velocity).norm();
  const Momenta momenta = engine.momenta();
  run.check(
      {.quantity = "speed apart",
       .unit = "m/s",
       .statement = "two bodies that just touch, and that nothing presses, stay at rest",
       .formula = "|v₂ − v₁| = 0",
       .source = "Newton's first law",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .scale = 1.0,
       .tolerance = 1e-9 + std::max(0.0, -gap) / engine.time_step(),
       .reason = "coordinates of 0.1 m round by 1e-17 m, which a step of 1e-5 s or more turns "
                 "into 1e-12 m/s; a thousand times that; what overlaps may be parted in a "
                 "step"},
      apart);
  run.check({.quantity = "linear momentum",
             .unit = "kg m/s",
             .statement = "what they do to each other is equal and opposite",
             .formula = "Σ m v = 0",
             .source = "Newton's third law",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .scale = 1.0,
             .tolerance = 1e-14,
             .reason = "masses of 1 kg, velocities of 1e-9 m/s at most: round-off of some hundred "
                       "vertices' sums"},
            momenta.linear.norm());
}

// Two boxes without weight that start inside each other by a share of their width: an engine may part
// them or refuse, not blow them up. What it parts them by is its own affair, but not the momentum.
void run_overlap(CaseRun& run, double share) {
  run.passages_are_noted();
  LadderBox left, right;
  left.cells = right.cells = 2;
  const double width = left.size.x();
  right.position = Vec3((1.0 - share) * width, 0.011, 0.007);
  Problem problem;
  problem.name = "two boxes";
  problem.bodies = {ladder_body(left, "left"), ladder_body(right, "right")};
  problem.friction = 0.0;
  constexpr double kEnd = 0.2;  // s
  double gap = 0.0, momentum = 0.0;
  std::string refused;
  try {
    const auto simulation = run.simulate(problem);
    simulation->record_frames(2e-3);
    simulation->advance_to(kEnd);
    const Engine& engine = simulation->engine();
    gap = (engine.body(1).position - engine.body(0).position).norm() / width - 1.0;
    const double speed = std::max(engine.body(0).velocity.norm(), 1e-12);
    momentum = engine.momenta().linear.norm() / speed;
    run.note("speed of the left one at the end: " + std::to_string(speed) + " m/s");
  } catch (const InputError& error) {
    refused = error.what();
    run.note("refused in words: " + refused);
  }
  run.check({.quantity = "overlap at the end",
             .unit = "1",
             .statement = "bodies that start inside each other part, or are refused in words",
             .formula = "max(0, −gap/width) = 0",
             .source = "bodies do not pass through each other",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .scale = 1.0,
             .tolerance = 1e-3,
             .reason = "a thousandth of their width: they touch, a contact's depth apart"},
            refused.empty() ? std::max(0.0, -gap) : 0.0);
  run.check(
      {.quantity = "linear momentum over that of one",
       .unit = "1",
       .statement = "what they do to each other is equal and opposite",
       .formula = "|Σ m v|/(m v) = 0",
       .source = "Newton's third law",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .scale = 1.0,
       .tolerance = 1e-10,
       .reason = "round-off of ten thousand steps, 1e-16 each, of which each may turn the last "
                 "bits of a hundred vertices"},
      momentum);
}

// Gravity lifts the box off and presses it back, so many times; then it must rest.
void run_hops(CaseRun& run, double hops) {
  LadderBox box, slab;
  slab.size = Vec3(0.3, 0.3, 0.05);
  slab.cells = 4;
  box.cells = 2;
  box.position = Vec3(0.013, 0.007, 0.0);
  Problem problem = ladder_problem(box_on_slab(box, slab), kLadderFriction, 0.0);
  const auto count = static_cast<int>(hops);
  Gravity gravity{{0.0}, {Vec3(0.0, 0.0, -kStandardGravity)}};
  for (int k = 0; k < count; ++k) {
    const double begin = kLadderDragFull * k / count, length = kLadderDragFull / count;
    for (const auto& [share, sign] : {std::pair{0.25, 0.2}, {0.5, -1.0}}) {
      gravity.time.push_back(begin + share * length);
      gravity.acceleration.push_back(sign * Vec3(0.0, 0.0, kStandardGravity));
    }
  }
  problem.gravity = gravity;
  check_ladder_rest(run, problem, "a box that was lifted off and pressed back rests again");
}

}  // namespace

std::vector<Case> cases_ladder_touch() {
  std::vector<Case> all;
  append(all, {.name = "coincidence",
               .parameter = "shift",
               .words = "flush boxes rest, shifted by so many metres",
               .rungs = {0, 1e-17, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3},
               .run = run_shift});
  append(all, {.name = "nearly-parallel",
               .parameter = "angle",
               .words = "a box rests that was laid down tilted by so many radians",
               .rungs = {1e-16, 1e-12, 1e-9, 1e-6, 1e-3, 1e-2},
               .run = run_tilt});
  append(all, {.name = "touching",
               .parameter = "gap",
               .words = "two weightless boxes so many metres apart stay where they are",
               .rungs = {-1e-12, -1e-15, 0, 1e-17, 1e-15, 1e-12, 1e-9},
               .run = run_gap});
  append(all, {.name = "overlap",
               .parameter = "share",
               .words = "boxes that start inside each other by such a share of their width part",
               .rungs = {1e-6, 1e-4, 1e-2, 0.05, 0.1, 0.2, 0.4},
               .quick = {1e-2},
               .run = run_overlap});
  append(all, {.name = "regained",
               .parameter = "hops",
               .words = "a box rests that was lifted off its slab so many times",
               .rungs = {1, 3, 10, 30, 100},
               .run = run_hops});
  return all;
}

}  // namespace stiction
