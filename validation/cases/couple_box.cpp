// SPDX-License-Identifier: GPL-3.0-or-later
// A box on level ground is turned about the vertical: friction holds up to a couple that depends on
// where the box presses, and that has a bound.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "validation/core/case_run.h"
#include "validation/estimate/threshold.h"
#include "validation/problems/turned_box_problem.h"

namespace stiction {

namespace {

const char* const kCoupleSource =
    "Coulomb's law: the friction of a turning body, over its contacts' places and forces";

struct Turn {
  double acceleration = 0.0;                               // about the vertical, 1/s²
  double held = std::numeric_limits<double>::quiet_NaN();  // min Σ μ N |p − c|, N m, if told
};

// The least of Σ μ N |p − c|, N m, over the centres c about which the box may turn: Weiszfeld's
// iteration, from the centre of pressure.
double most_held(const std::vector<ContactSample>& contacts, double friction) {
  Vec3 centre = Vec3::Zero();
  double pressed = 0.0;
  for (const ContactSample& contact : contacts) {
    centre += contact.normal_force * contact.position;
    pressed += contact.normal_force;
  }
  centre /= pressed;
  double couple = 0.0;
  for (int k = 0; k < 1000; ++k) {
    Vec3 sum = Vec3::Zero();
    double weights = 0.0;
    couple = 0.0;
    for (const ContactSample& contact : contacts) {
      const double arm = std::max((contact.position - centre).head<2>().norm(), 1e-9);
      couple += friction * contact.normal_force * arm;
      sum += contact.normal_force / arm * contact.position;
      weights += contact.normal_force / arm;
    }
    centre = sum / weights;
  }
  return couple;
}

Turn turn_of(CaseRun& run, const TurnedBoxSetup& setup) {
  constexpr double kWindow = 0.2;  // s
  const auto simulation = run.simulate(turned_box_problem(setup));
  simulation->record_frames(0.02);
  const Engine& engine = simulation->engine();
  simulation->advance_to(kTurnFull);
  const double begin = simulation->time(), before = engine.body(0).angular_velocity.z();
  std::vector<ContactSample> pressed;  // of all looks, a share of its force each
  constexpr int kLooks = 50;
  for (int k = 1; k <= kLooks; ++k) {
    simulation->advance_to(kTurnFull + kWindow * k / kLooks);
    if (!run.engine().manifest.contacts) continue;
    for (ContactSample contact : engine.contacts()) {
      contact.normal_force /= kLooks;
      pressed.push_back(contact);
    }
  }
  Turn turn;
  turn.acceleration = (engine.body(0).angular_velocity.z() - before) / (simulation->time() - begin);
  if (run.engine().manifest.contacts) turn.held = most_held(pressed, setup.friction);
  return turn;
}

// Of the box about the vertical, kg m².
double inertia(const TurnedBoxSetup& setup) { return setup.mass * setup.face * setup.face / 6.0; }

void run_above(CaseRun& run, TurnedBoxSetup setup) {
  constexpr double kShare = 1.25;
  setup.couple = kShare * most_couple(setup);
  const Turn turn = turn_of(run, setup);
  const double least = (kShare - 1.0) * most_couple(setup) / inertia(setup);
  const double most = setup.couple / inertia(setup);
  run.check(
      {.quantity = "angular acceleration",
       .unit = "1/s²",
       .statement = "no pressure holds more than μ m g a/√2: the box spins up",
       .formula = "(τ − μ m g a/√2)/J ≤ α ≤ τ/J",
       .source = kCoupleSource,
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.5 * (least + most),
       .tolerance = 0.5 * (most - least) + 1e-9 * most,
       .reason = "both ends of the interval: pressure on the corners, and at the centre; "
                 "1e-9 of τ/J for round-off, which an engine that presses on the corners needs"},
      turn.acceleration);
}

void run_threshold(CaseRun& run, TurnedBoxSetup setup) {
  constexpr double kGives = 1e-5;  // of τ_max/J: what spins up faster is not held
  constexpr double kWidth = 1e-5;  // of the bracket, to τ_max
  const double most = most_couple(setup);
  Turn held;
  const auto holds = [&](double couple) {
    setup.couple = couple;
    const Turn turn = turn_of(run, setup);
    const bool yes = turn.acceleration < kGives * most / inertia(setup);
    if (yes) held = turn;
    return yes;
  };
  const Bracket bracket = find_threshold(0.0, 1.5 * most, kWidth * most, holds);
  const double couple = bracket.middle() - kGives * most;
  run.check({.quantity = "couple above the bound",
             .unit = "N m",
             .statement = "no couple above μ m g a/√2 is held",
             .formula = "max(0, τ − μ m g a/√2) = 0",
             .source = kCoupleSource,
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .relative = true,
             .scale = most,
             .tolerance = kWidth,
             .reason = "the bracket's width; what counts as held spins up by 1e-5 μ m g a/(√2 J) "
                       "at most, which is taken off"},
            std::isnan(couple) ? couple : std::max(0.0, couple - most));
  run.note(
      fmt::format("the most that is held is {:.5f} μ m g a: 0.7071 on the corners, 0.3826 under "
                  "uniform pressure; {} runs",
                  couple / most / std::sqrt(2.0), bracket.evaluations));
  if (!run.engine().manifest.contacts) return;
  const Claim common{.unit = "N m",
                     .formula = "τ = min over c of Σ μ N |p − c|",
                     .source = kCoupleSource,
                     .kind = ReferenceKind::kExactComputed,
                     .relative = true,
                     .scale = held.held};
  Claim most_of_all = common;
  most_of_all.quantity = "couple above what the contacts can hold";
  most_of_all.statement = "… nor any above what the contacts' own forces can hold";
  most_of_all.tolerance = 2.0 * kWidth;
  most_of_all.reason = "the bracket's width, and as much for Weiszfeld's iteration";
  run.check(most_of_all, std::isnan(couple) ? couple : std::max(0.0, couple - held.held));
  Claim all_of_it = common;
  all_of_it.quantity = "most couple held";
  all_of_it.statement = "a rigid body is held by all that its contacts can";
  all_of_it.expected = held.held;
  all_of_it.tolerance = 2.0 * kWidth;
  all_of_it.reason = most_of_all.reason;
  if (!run.engine().manifest.deformable) {
    run.check(all_of_it, couple);
    return;
  }
  all_of_it.statement = "how much of what its contacts can an elastic body is held by";
  all_of_it.reason =
      "not judged: its contacts keep friction across the turn since the body spread under its "
      "weight, and its pressure moves as they begin to slip";
  run.show(all_of_it, couple);
}

}  // namespace

std::vector<Case> cases_couple_box() {
  const TurnedBoxSetup setup;
  return {{.name = "couple/box/above",
           .title = "a couple above all that friction holds spins a box up",
           .set = CaseSet::kQuick,
           .run = [=](CaseRun& run) { run_above(run, setup); }},
          {.name = "couple/box/threshold",
           .title = "the most couple that holds a box on level ground",
           .run = [=](CaseRun& run) { run_threshold(run, setup); }}};
}

}  // namespace stiction
