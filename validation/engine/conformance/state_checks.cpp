// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the same state has the same future.
#include <fmt/format.h>

#include <cmath>

#include "validation/engine/conformance/probe.h"

namespace stiction {

namespace {

// A body that is thrown at the ground and slides on: contacts, and whatever an engine remembers of them.
Problem thrown(const Probe& probe) {
  Problem problem;
  problem.name = "a body thrown at the ground";
  ProblemBody body = probe.body("body");
  body.position = Vec3(0.0, 0.0, 0.11);
  body.velocity = Vec3(1.0, 0.3, -0.5);
  if (probe.manifest().spin) body.angular_velocity = Vec3(0.3, -0.2, 1.0);
  problem.bodies = {body};
  problem.obstacles = {{"ground", Vec3::Zero(), Vec3::UnitZ(), 0.4}};
  problem.gravity = {{0.0}, {Vec3(0.0, 0.0, -9.81)}};
  return problem;
}

double apart(const BodyMotion& a, const BodyMotion& b) { return (a.position - b.position).norm(); }

double speed_apart(const BodyMotion& a, const BodyMotion& b) {
  return (a.velocity - b.velocity).norm() + (a.angular_velocity - b.angular_velocity).norm();
}

}  // namespace

std::string check_snapshots(const Probe& probe) {
  probe.need(probe.manifest().snapshots, "saved states");
  const auto engine = probe.start(thrown(probe));
  advance_to(*engine, 0.1);
  const BodyMotion then = engine->body(0);
  const std::uint64_t steps = engine->steps_done();
  const Snapshot saved = engine->save();
  advance_to(*engine, 0.2);
  const BodyMotion first = engine->body(0);
  engine->restore(saved);
  if (engine->steps_done() != steps) throw Nonconformity("a restored state has another time");
  const BodyMotion back = engine->body(0);
  if (apart(back, then) > 0.0) {
    throw Nonconformity(
        fmt::format("a restored body is {:.3g} m from where it was saved", apart(back, then)));
  }
  if (speed_apart(back, then) > 0.0) {
    throw Nonconformity(fmt::format(
        "a restored body has forgotten its velocity: {:.4g} m/s where it was saved with {:.4g}",
        back.velocity.norm(), then.velocity.norm()));
  }
  advance_to(*engine, 0.2);
  const BodyMotion second = engine->body(0);
  if (apart(first, second) > 0.0 || speed_apart(first, second) > 0.0) {
    throw Nonconformity(fmt::format(
        "from a restored state the body gets {:.3g} m elsewhere in 0.1 s than from the same state "
        "the first time, with {:.3g} m/s more or less: something that the future depends on is not "
        "saved",
        apart(first, second), speed_apart(first, second)));
  }
  return "a restored state has the same future, to the last bit";
}

std::string check_repeats(const Probe& probe) {
  const Problem problem = thrown(probe);
  const auto one = probe.start(problem), other = probe.start(problem);
  const double time = advance_to(*one, 0.2);
  for (int k = 1; k <= 5; ++k) advance_to(*other, 0.04 * k);
  if (one->steps_done() != other->steps_done()) throw Nonconformity("its time step changes");
  const double distance = apart(one->body(0), other->body(0));
  if (distance > 0.0) {
    throw Nonconformity(
        fmt::format("run once in one go and once in five, a body ends {:.3g} m apart after {:.3g} "
                    "s: steps must "
                    "not depend on how they are asked for",
                    distance, time));
  }
  return "the same to the last bit, in one go or in five";
}

std::string check_finer(const Probe& probe) {
  const double usual = probe.start(thrown(probe))->time_step();
  const double finer = probe.start(thrown(probe), {.finer = 2.0})->time_step();
  if (!(std::abs(finer / usual - 0.5) < 1e-3)) {
    throw Nonconformity(
        fmt::format("asked for steps half as long as its own, {:.6g} s, it takes {:.6g} s: divide "
                    "the time step "
                    "by `finer`",
                    usual, finer));
  }
  return fmt::format("{:.6g} s, and half of that where it is asked for", usual);
}

}  // namespace stiction
