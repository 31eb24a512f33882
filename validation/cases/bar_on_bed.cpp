// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "validation/core/case_run.h"
#include "validation/problems/bar_problem.h"

namespace stiction {

namespace {

// A long elastic bar lies on a rigid bed; its one end is held and pushed along by U, back to 0, and
// again. Friction resists with τ = μ ρ g A per length, so the bar slides only as far as it has to:
// with EA u″ = τ in the sliding part, u = u′ = 0 where it ends,
//
//   u(x) = τ (a − x)²/(2EA),   a = √(2 E A U/τ),   F = τ a.
//
// Going back by δ, friction turns over first near the end: twice the traction over a part of
// b = √(E A δ/τ), and F falls by 2 τ b; b = a/√2 when the end is back. Coming again, the same once
// more, so that the loop between 0 and U is closed, and takes
//
//   W = ∮ F dδ = ⅔ τ b U,   which is 2 F_a³/(3 E A τ) for the force's amplitude F_a = τ b.
//
// A meshed bar's held end carries the weight of half a cell, e, on which friction has no hold:
//
//   U = τ (a²/2 + e a)/EA,   δ = τ (b² + 2 e b)/EA,   F = τ a,   W = 2 τ² b³/(3EA).
//
// Poisson's ratio is 0: the bar is then the one-dimensional one, but for its height h. Friction
// acts h/2 below the axis: a couple τh/2 per length, which the weight carries to the ends of the
// sliding part as forces ± τh/2 on the bed. Each is as much traction as μh/2 of bar: kFlexure of
// length.
constexpr BarSetup kBar;
constexpr double kLength = kBar.length;                 // m
constexpr double kStiffness = bar_stiffness(kBar);      // EA, N
constexpr double kTraction = bar_traction(kBar);        // τ, N/m
constexpr double kSlipLength = kBar.slip_length;        // a, m
constexpr double kPush = bar_push(kBar);                // U, m
constexpr double kFlexure = kBar.friction * kBar.side;  // μh/2 at both ends, m
constexpr int kCells = 80;                              // along the bar
constexpr double kTurn = bar_turn(kBar);                // s, from one end of a stroke to another

using Places = std::map<std::int64_t, Vec3>;  // of vertices, by their numbers, m

// What the bed does to the bar. The end that is held carries the rest of its weight.
struct Bed {
  double friction = 0.0;  // Σ f along the bar, N
  double power = 0.0;     // Σ f · u, W
  double fastest = 0.0;   // m/s
  Places places;          // of the touching points, m
};

Bed bed_of(const Engine& engine) {
  Bed bed;
  for (const ContactSample& contact : engine.contacts()) {
    bed.friction += contact.friction_force.x();
    bed.power += contact.friction_force.dot(contact.slip);
    bed.fastest = std::max(bed.fastest, contact.slip.norm());
    bed.places[contact.point] = contact.position;
  }
  return bed;
}

struct Stroke {
  double reaction = 0.0;  // of the bed at rest at its end, N
  double friction = 0.0;  // work of friction during it, J
  double end_work = 0.0;  // ∫ F dU during it, J
};

// Lengths a and b of the sliding parts, m, where the first `dead` metres have no friction.
double first_length(double dead) {
  return std::sqrt(dead * dead + kSlipLength * kSlipLength) - dead;
}
double turned_length(double dead) {
  return std::sqrt(dead * dead + 0.5 * kSlipLength * kSlipLength) - dead;
}

void check_push(CaseRun& run, const Places& start, const Places& pushed,
                const std::vector<Stroke>& strokes, double cell) {
  const double length = first_length(0.5 * cell);
  double furthest = 0.0;
  double worst = 0.0;
  double worst_at = 0.0;
  for (const auto& [point, place] : pushed) {
    const auto from = start.find(point);
    if (from == start.end()) continue;
    const double x = from->second.x();
    const double moved = place.x() - x;
    const double left = std::max(0.0, length + 0.5 * cell - x);
    const double error = moved - kTraction * left * left / (2.0 * kStiffness);
    if (std::abs(moved) > 1e-3 * kPush) furthest = std::max(furthest, x);
    if (std::abs(error) < std::abs(worst)) continue;
    worst = error;
    worst_at = x;
  }
  run.check(
      {.quantity = "slip length",
       .unit = "m",
       .statement = "the bar slides over the length that carries the push, and rests behind it",
       .formula = "a = √(2EAU/τ) (with U = τ(a²/2 + ea)/EA, e = half a cell)",
       .source = "bar on a frictional bed, derived in the file",
       .kind = ReferenceKind::kAnalytic,
       .expected = length + 0.5 * cell,
       .tolerance = 1.5 * cell + 0.032 * length,
       .reason = "a vertex counts once it has moved by 1e-3 U, which is √1e-3 = 3.2 % of a "
                 "before the end; vertices are a cell apart, and the end is rounded by half"},
      furthest);
  run.check({.quantity = "displacement profile, largest error",
             .unit = "m",
             .statement = "every point is where the push puts it",
             .formula = "u(x) = τ(a − x)²/(2EA)",
             .source = "bar on a frictional bed, derived in the file",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .relative = true,
             .scale = kPush,
             .tolerance = kFlexure / length,
             .reason = "friction below the axis: μh/2 of bar at both ends of the sliding part"},
            worst, fmt::format("x = {:.4f} m", worst_at));
  run.check({.quantity = "reaction of the bed",
             .unit = "N",
             .statement = "the push is carried by friction at its limit over the slip length",
             .formula = "F = τ a = √(2EAUτ)",
             .source = "bar on a frictional bed, derived in the file",
             .kind = ReferenceKind::kAnalytic,
             .expected = kTraction * length,
             .relative = true,
             .tolerance = kFlexure / length,
             .reason = "friction below the axis: μh/2 of bar at both ends of the sliding part; "
                       "inertia (ȧ/c)² = 1e-3 of that is gone after the hold"},
            strokes[0].reaction);
}

void check_cycle(CaseRun& run, const std::vector<Stroke>& strokes, double cell) {
  const double dead = 0.5 * cell;
  const double back = turned_length(dead);
  const double loss = 2.0 / 3.0 * kTraction * kTraction * back * back * back / kStiffness;
  const double friction = -(strokes[1].friction + strokes[2].friction);
  const double work = strokes[1].end_work + strokes[2].end_work;
  run.check(
      {.quantity = "reaction when the end is back",
       .unit = "N",
       .statement = "pulled back to its place, the end is held back: friction has turned over",
       .formula = "F = τ(a − 2b), b = √(EAU/τ) = a/√2",
       .source = "bar on a frictional bed, derived in the file",
       .kind = ReferenceKind::kAnalytic,
       .expected = kTraction * (first_length(dead) - 2.0 * back),
       .relative = true,
       .scale = kTraction * first_length(dead),
       .tolerance = kFlexure / back,
       .reason = "friction below the axis: μh/2 of bar at both ends of the turned part"},
      strokes[1].reaction);
  run.check({.quantity = "reaction after the second push",
             .unit = "N",
             .statement = "the second push ends where the first did: the loop is closed",
             .formula = "F(U) = τ a again",
             .source = "Masing's rule: the loop of a bar on a bed",
             .kind = ReferenceKind::kAnalytic,
             .expected = strokes[0].reaction,
             .relative = true,
             .tolerance = 1e-3,
             .reason = "inertia of the strokes, (ȧ/c)² with ȧ = aU̇/(2U) ≤ 0.8 m/s and c = 22 m/s: "
                       "1.3e-3 of a part of F, and the hold undoes most of it"},
            strokes[2].reaction);
  run.check({.quantity = "friction loss of a cycle",
             .unit = "J",
             .statement = "a cycle between 0 and U loses what partial slip says",
             .formula = "W = 2F_a³/(3EAτ), F_a = τ b half the range of F",
             .source = "bar on a frictional bed: friction per length τ ends where it has carried F",
             .kind = ReferenceKind::kAnalytic,
             .expected = loss,
             .relative = true,
             .tolerance = 3.0 * kFlexure / back,
             .reason = "W ∝ b³, and b is known to μh/2 at both ends of the turned part"},
            friction);
  run.check({.quantity = "friction loss against the work of the end",
             .unit = "J",
             .statement = "what the end puts in over a cycle is what friction takes out",
             .formula = "∮ F dU = −Σ Δt Σ f · u",
             .source = "energy balance of a closed loop",
             .kind = ReferenceKind::kAnalytic,
             .expected = work,
             .relative = true,
             .tolerance = 3e-3,
             .reason = fmt::format("viscous loss β/T = {:.0e} of the elastic energy with a factor "
                                   "of the ramp's shape, and inertia, 1.3e-3",
                                   kBar.damping_time / kBar.ramp)},
            friction);
  run.note(
      fmt::format("reaction {:.5f} N (closed form {:.5f}; of a bar without half a cell on the held "
                  "end {:.5f}), "
                  "back {:.5f} ({:.5f}), again {:.5f}; loss of a cycle {:.4e} J ({:.4e})",
                  strokes[0].reaction, kTraction * first_length(dead), kTraction * kSlipLength,
                  strokes[1].reaction, kTraction * (first_length(dead) - 2.0 * back),
                  strokes[2].reaction, friction, loss));
}

void run_bar(CaseRun& run) {
  const Problem problem = bar_problem(kBar);
  const CaseRun::Running simulation = run.simulate(problem, {.fineness = kCells});
  const double cells = simulation->engine().fineness();
  const Engine& engine = simulation->engine();
  const double dt = engine.time_step();
  const Motion& motion = problem.bodies[0].motion;
  Series kinetic{"kinetic energy", "J", "time", "s", {}, {}};
  Series slip{"fastest contact slip", "m/s", "time", "s", {}, {}};
  Series loop{"reaction of the bed", "N", "displacement of the end", "m", {}, {}};

  simulation->advance_to(kBar.settled);
  const Places start = bed_of(engine).places;
  Places pushed;
  std::vector<Stroke> strokes;
  const int every = static_cast<int>(std::llround(kTurn / dt / 60.0));
  for (int s = 0; s < 3; ++s) {
    Stroke stroke;
    const double end = kBar.settled + (s + 1) * kTurn;
    while (simulation->time() < end - 0.5 * dt) {
      const double before = motion.at(simulation->time()).x();
      simulation->advance(1);
      const Bed bed = bed_of(engine);
      stroke.friction += dt * bed.power;
      stroke.end_work -= bed.friction * (motion.at(simulation->time()).x() - before);
      stroke.reaction = -bed.friction;
      if (engine.steps_done() % static_cast<std::uint64_t>(every) != 0) continue;
      kinetic.x.push_back(simulation->time());
      kinetic.y.push_back(engine.kinetic_energy());
      slip.x.push_back(simulation->time());
      slip.y.push_back(bed.fastest);
      loop.x.push_back(motion.at(simulation->time()).x());
      loop.y.push_back(-bed.friction);
    }
    strokes.push_back(stroke);
    if (s == 0) pushed = bed_of(engine).places;
  }
  run.add(std::move(kinetic));
  run.add(std::move(slip));
  run.add(std::move(loop));

  check_push(run, start, pushed, strokes, kLength / cells);
  check_cycle(run, strokes, kLength / cells);
}

}  // namespace

std::vector<Case> cases_bar_on_bed() {
  return {{.name = "bar-on-bed/slip-length",
           .title = "a long bar pushed at its end slides only as far as it has to",
           .run = run_bar}};
}

}  // namespace stiction
