// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "validation/core/case_run.h"
#include "validation/problems/slopes/slab_problem.h"

namespace stiction {

namespace {

// A box that lies on a held deformable slab is pushed along it below the friction limit and let go,
// twice. What should be left?
//
// A rigid box: nothing. An elastic one may keep something: under the push the edges of the contact
// slip a little, and friction locks part of that in when the push is gone. But the state at the end
// of an unloading is the start of the next loading, and a frictional contact under a periodic load
// follows the same loop each time (Masing): a second push to the same load must leave nothing new.
// Friction memory that is stale, i.e. forces of the push that outlive it, would show as a box that
// goes on moving, springs back beyond its start, or creeps with each cycle.

constexpr double kSettled = 0.4;                           // s: gravity is in since 0.2 s
constexpr double kRamp = 0.25, kHold = 0.25, kRest = 0.4;  // s
constexpr double kLastRest = 0.5;                          // s, more, after the last cycle
constexpr int kCycles = 2;
constexpr double kCycle = 2.0 * kRamp + kHold + kRest;
constexpr double kPushDamping = 2e-3;  // β, s

SlabSetup pushed_slab() {
  SlabSetup setup;
  setup.elasticity.damping_time = kPushDamping;
  setup.azimuth = std::numbers::pi / 6.0;
  setup.yaw = 17.0 * std::numbers::pi / 180.0;
  setup.offset = {0.013, 0.007, 0.0};
  return setup;
}

// Sideways gravity of `ratio` times the weight comes and goes.
Problem pushed(const SlabSetup& setup, double ratio) {
  Problem problem = slab_problem(setup);
  const Vec3 weight(0.0, 0.0, -kStandardGravity);
  const Vec3 push = weight + ratio * kStandardGravity * slab_downhill(setup);
  Gravity& gravity = problem.gravity;
  gravity = {{0.0, 0.2}, {Vec3::Zero(), weight}};
  for (int cycle = 0; cycle < kCycles; ++cycle) {
    const double begin = kSettled + cycle * kCycle;
    gravity.time.insert(gravity.time.end(),
                        {begin, begin + kRamp, begin + kRamp + kHold, begin + 2.0 * kRamp + kHold});
    gravity.acceleration.insert(gravity.acceleration.end(), {weight, push, push, weight});
  }
  problem.duration = kSettled + kCycles * kCycle + kLastRest;
  return problem;
}

struct Push {
  std::vector<Vec3> at_peak;  // place of the box while it is pushed, m
  std::vector<Vec3> after;    // … at the end of the rest; the first entry is before any push
  double kinetic = 0.0;       // at the end, J
};

Push push(CaseRun& run, const SlabSetup& setup, double ratio) {
  const Problem problem = pushed(setup, ratio);
  const CaseRun::Running simulation = run.simulate(problem, {.fineness = setup.cells});
  const Engine& engine = simulation->engine();
  const Vec3 along = slab_downhill(setup);
  Push found;
  Series kinetic{"kinetic energy", "J", "time", "s", {}, {}};
  Series slip{"fastest contact slip", "m/s", "time", "s", {}, {}};
  Series travel{"travel of the box along the push", "m", "time", "s", {}, {}};
  const Vec3 start = engine.body(0).position;
  const auto advance = [&](double time) {
    while (simulation->time() < time - 0.5 * engine.time_step()) {
      simulation->advance_to(std::min(time, simulation->time() + 0.025));
      double fastest = 0.0;
      for (const ContactSample& contact : engine.contacts()) {
        if (contact.normal_force > 0.0) fastest = std::max(fastest, contact.slip.norm());
      }
      for (Series* series : {&kinetic, &slip, &travel}) series->x.push_back(simulation->time());
      kinetic.y.push_back(engine.kinetic_energy());
      slip.y.push_back(fastest);
      travel.y.push_back(along.dot(engine.body(0).position - start));
    }
  };
  advance(kSettled);
  found.after.push_back(engine.body(0).position);
  for (int cycle = 0; cycle < kCycles; ++cycle) {
    const double begin = kSettled + cycle * kCycle;
    advance(begin + kRamp + kHold);
    found.at_peak.push_back(engine.body(0).position);
    advance(begin + kCycle);
    found.after.push_back(engine.body(0).position);
  }
  advance(problem.duration);
  found.kinetic = engine.kinetic_energy();
  run.add(std::move(kinetic));
  run.add(std::move(slip));
  run.add(std::move(travel));
  return found;
}

// Part of its largest displacement that a ball on a flat keeps when a push of `part` of the limit
// is taken back: δ ∝ 1 − (1 − q)^⅔ on loading, twice as much of half the load on unloading.
double mindlin_residual(double part) {
  const auto way = [](double q) { return 1.0 - std::pow(1.0 - q, 2.0 / 3.0); };
  return 1.0 - 2.0 * way(0.5 * part) / way(part);
}

// What vibration is left, as a part of the box's displacement A under the push. The box swings at
// ω = √(push/A) per unit mass. The smooth step's third derivative jumps by 60/T³ at both of its
// ends, which leaves at most 120/(ωT)³ swinging, and damping takes ½βω² of it per second.
double vibration_left(double frequency, double rest) {
  return 120.0 / std::pow(frequency * kRamp, 3) *
         std::exp(-0.5 * kPushDamping * frequency * frequency * rest);
}

void run_push(CaseRun& run, double part) {
  const SlabSetup setup = pushed_slab();
  const Push found = push(run, setup, part * setup.friction);
  const Vec3 along = slab_downhill(setup);
  const double peak = along.dot(found.at_peak[0] - found.after[0]);
  const double first = along.dot(found.after[1] - found.after[0]);
  const double second = along.dot(found.after[2] - found.after[1]);
  const double across = (found.after[2] - found.after[0]).cross(along).norm();
  const double frequency = std::sqrt(part * setup.friction * kStandardGravity / std::abs(peak));
  const double swing = vibration_left(frequency, kRest);
  const std::string swing_reason = fmt::format(
      "vibration left: the box swings at ω = √(push/A) = {:.0f} rad/s; a C² ramp of T leaves "
      "120/(ωT)³ of A, damped by ½βω² for {:.1f} s: {:.1e} A",
      frequency, kRest, swing);
  run.check(
      {.quantity = "spring-back behind the start, after the first push",
       .unit = "m",
       .statement = "a box that is let go does not end behind the place where it was pushed from",
       .formula = "x₁ − x₀ ≥ 0, relative to its displacement A under the push",
       .source = "no friction force of the push outlives it",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .relative = true,
       .scale = peak,
       .tolerance = swing,
       .reason = swing_reason},
      std::min(0.0, first));
  run.check(
      {.quantity = "displacement left by the first push",
       .unit = "m",
       .statement = "below the friction limit only the micro-slip of an elastic contact may stay",
       .formula = "|x₁ − x₀|/A ≤ 1 − 2(1 − (1 − q/2)^⅔)/(1 − (1 − q)^⅔), q = push/(μ weight)",
       .source = "Mindlin's partial slip of a ball on a flat",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .relative = true,
       .scale = peak,
       .tolerance = mindlin_residual(part),
       .reason = "what a ball keeps, whose pressure falls to zero at the contact's edge; a "
                 "flat face under even pressure slips less"},
      first);
  run.check({.quantity = "displacement added by the second push",
             .unit = "m",
             .statement = "a second push to the same load leaves nothing new",
             .formula = "x₂ − x₁ = 0, relative to A",
             .source = "Masing: the state after an unloading closes the loop",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .relative = true,
             .scale = peak,
             .tolerance = swing,
             .reason = swing_reason},
            second);
  // Box and slab (2 kg, held below: a third of it swings with the box).
  constexpr double kSwinging = 1.0 + 2.0 / 3.0;
  const double still = vibration_left(frequency, kRest + kLastRest) * frequency * peak;
  run.check(
      {.quantity = "kinetic energy at the end",
       .unit = "J",
       .statement = "… and it comes to rest",
       .formula = "½Σmv² → 0",
       .source = "damping",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .tolerance = 0.5 * kSwinging * still * still,
       .reason = "½ m (ωa)² of the vibration a that is left after 0.9 s, m the box and a third of "
                 "the slab"},
      found.kinetic);
  run.note(fmt::format(
      "displacement under the push {:.4e} m (second time {:.4e}); left by the first {:.3e}, added "
      "by the second {:.3e}, across the push {:.1e} m",
      peak, along.dot(found.at_peak[1] - found.after[0]), first, second, across));
}

}  // namespace

std::vector<Case> cases_push_and_retract() {
  std::vector<Case> cases;
  for (const int percent : {40, 80}) {
    cases.push_back({.name = fmt::format("push-and-retract/slab/{}%", percent),
                     .title = fmt::format(
                         "a box on a slab, pushed twice to {} % of the friction limit", percent),
                     .run = [percent](CaseRun& run) { run_push(run, percent / 100.0); }});
  }
  return cases;
}

}  // namespace stiction
