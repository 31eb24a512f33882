// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "validation/problems/free_boxes.h"

namespace stiction {

namespace {

// Energy under symplectic Euler. v_n belongs to the time t_n − Δt/2 (leapfrog), so ½mv² + U at one
// index is wrong by a term of first order that changes its sign with the vibration. The mean of two
// steps' kinetic energies takes that out:
//
//   E_n = U(x_n) + ½(K_n + K_{n+1}) = [½m v_n v_{n+1} + U(x_n)] + ¼ m|Δv|²
//
// with Δv = v_{n+1} − v_n. The bracket is exactly constant for every linear spring; the rest, with
// Δv = Δt ω² x, is at most ½(ωΔt)² times the energy of the vibration of frequency ω.

constexpr double kCollisionTime = 0.1;  // s
constexpr double kApart = 0.06;         // s; the boxes have left each other long before
constexpr double kSpeed = 0.5;          // m/s, of either box

// Two cubes meet face on, 2 cm beside each other's centre; the upper one is turned by 17° about the
// normal and tilted by 3°, so that their meshes have nothing in common.
Problem collision(double friction, double oblique, double damping) {
  const Vec3 velocity = kSpeed * Vec3(oblique, 0.3 * oblique, 1.0).normalized();
  Problem problem = free_problem("two boxes collide",
                                 {free_cube("lower", {0.0, 0.0, -0.051}, velocity, damping),
                                  free_cube("upper", {0.02, -0.011, 0.054}, -velocity, damping)},
                                 kCollisionTime);
  problem.friction = friction;
  problem.bodies[1].rotation = Eigen::AngleAxisd(std::numbers::pi * 17.0 / 180.0, Vec3::UnitZ()) *
                               Eigen::AngleAxisd(std::numbers::pi / 60.0, Vec3::UnitX());
  return problem;
}

struct Outcome {
  double start = 0.0;         // E_0, J
  double highest = 0.0;       // max E_n, J
  double highest_at = 0.0;    // s
  double end = 0.0;           // mean E_n once the boxes are apart, J
  double translation = 0.0;   // kinetic energy of the centres of mass at the end, J
  double linear_error = 0.0;  // largest |P_n − P_0|, kg m/s
  double linear_scale = 0.0;  // Σ m|v| at the start, kg m/s
  double contact_time = 0.0;  // s, from the first to the last contact
};

Outcome collide(CaseRun& run, const Problem& problem, const std::string& label) {
  const CaseRun::Running simulation = simulate_free(run, problem);
  const Engine& engine = simulation->engine();
  Outcome outcome;
  outcome.linear_scale = momentum_scale(problem);
  const Momenta start = engine.momenta();
  Energies now = engine.energies();
  outcome.start = outcome.highest = now.kinetic;
  Series energy{fmt::format("{}: energy over the start's", label), "1", "time", "s", {}, {}};
  Series kinetic{fmt::format("{}: kinetic energy", label), "J", "time", "s", {}, {}};
  Series slip{fmt::format("{}: fastest contact slip", label), "m/s", "time", "s", {}, {}};
  double first_contact = -1.0;
  double last_contact = -1.0;
  int apart_count = 0;
  while (simulation->time() < problem.duration - 0.5 * engine.time_step()) {
    const double time = simulation->time();
    simulation->advance(1);
    const Energies next = engine.energies();
    const double total = now.elastic + 0.5 * (now.kinetic + next.kinetic);
    now = next;
    if (total > outcome.highest) {
      outcome.highest = total;
      outcome.highest_at = time;
    }
    if (time >= kApart) {
      outcome.end += total;
      ++apart_count;
    }
    outcome.linear_error =
        std::max(outcome.linear_error, (engine.momenta().linear - start.linear).norm());
    double fastest = 0.0;
    for (const ContactSample& contact : engine.contacts()) {
      if (contact.normal_force == 0.0) continue;
      fastest = std::max(fastest, contact.slip.norm());
      if (first_contact < 0.0) first_contact = time;
      last_contact = simulation->time();
    }
    if (engine.steps_done() % 5 != 0) continue;
    for (Series* series : {&energy, &kinetic, &slip}) series->x.push_back(time);
    energy.y.push_back(total / outcome.start);
    kinetic.y.push_back(next.kinetic);
    slip.y.push_back(fastest);
  }
  outcome.end /= apart_count;
  outcome.contact_time = last_contact - first_contact;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    outcome.translation += 0.5 * problem.bodies[b].mass * engine.body(b).velocity.squaredNorm();
  }
  run.add(std::move(energy));
  run.add(std::move(kinetic));
  run.add(std::move(slip));
  return outcome;
}

void check_outcome(CaseRun& run, const Outcome& found, const std::string& label) {
  run.check({.quantity = fmt::format("linear momentum, largest change: {}", label),
             .unit = "kg m/s",
             .statement = "two free bodies keep their linear momentum in a collision",
             .formula = "Σ m v(t) = Σ m v(0)",
             .source = "[Lazarevych2009], appendix A",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .relative = true,
             .scale = found.linear_scale,
             .tolerance = 1e-12,
             .reason = "round-off: 500 steps of 250 vertices at 1e-16 of a vertex's momentum give "
                       "1e-15, and three decades for the strong forces of the impact"},
            found.linear_error);
  // The slowest vibration that a collision excites is its own half wave; a box's fastest one that
  // carries energy is some ten times as fast, with a hundredth of the energy.
  run.check(
      {.quantity = fmt::format("energy above the start: {}", label),
       .unit = "J",
       .statement = "a collision never has more energy than there was at the start",
       .formula = "E_n = U(x_n) + ½(K_n + K_{n+1}) ≤ E_0",
       .source = "energy balance; symplectic Euler as leapfrog, see the comment in the file",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .relative = true,
       .scale = found.start,
       .tolerance = 1e-3,
       .reason = "½(ωΔt)² of the vibration's energy: ω = π/10 ms and Δt = 2e-4 s give 2e-3 of "
                 "the elastic half; contact itself only takes"},
      found.highest - found.start, fmt::format("t = {:.4f} s", found.highest_at));
  run.check({.quantity = fmt::format("energy after the collision, if above the start: {}", label),
             .unit = "J",
             .statement = "… nor has it gained any when the boxes are apart again",
             .formula = "E(t > 0.06 s) ≤ E_0",
             .source = "energy balance",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .relative = true,
             .scale = found.start,
             .tolerance = 1e-12,
             .reason = "an inequality; what the integrator adds to E_n is far below what the "
                       "contact takes"},
            std::max(0.0, found.end - found.start));
  run.note(fmt::format(
      "{}: linear momentum off by {:.1e} of Σ m|v|; energy afterwards {:.4f} of the start's "
      "(translation {:.4f}), at most {:.4f}; contact for {:.1f} ms",
      label, found.linear_error / found.linear_scale, found.end / found.start,
      found.translation / found.start, found.highest / found.start, 1e3 * found.contact_time));
}

void run_collision(CaseRun& run) {
  // Without friction and damping nothing takes energy but the contact itself.
  check_outcome(run, collide(run, collision(0.0, 0.0, 0.0), "elastic, head-on"),
                "elastic, head-on");
  check_outcome(run, collide(run, collision(0.5, 1.0, 0.0), "elastic, oblique, μ = 0.5"),
                "elastic, oblique, μ = 0.5");
  check_outcome(run, collide(run, collision(0.5, 1.0, 1e-3), "damped, oblique, μ = 0.5"),
                "damped, oblique, μ = 0.5");
}

}  // namespace

std::vector<Case> cases_two_body_collision() {
  return {{.name = "two-body/free-collision",
           .title = "two free boxes collide: momentum stays, energy is not created",
           .run = run_collision}};
}

}  // namespace stiction
