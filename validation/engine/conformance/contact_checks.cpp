// SPDX-License-Identifier: GPL-3.0-or-later
// What an adapter makes of contact: whose force it is, in which units, and which μ.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "validation/engine/conformance/probe.h"

namespace stiction {

namespace {

constexpr double kGravity = 9.81;  // m/s²
constexpr double kForces = 0.1;    // relative: of a weight at rest, where soft contacts still ring

// A body on level ground.
Problem on_ground(const Probe& probe, double friction) {
  Problem problem;
  problem.name = "a body on level ground";
  ProblemBody body = probe.body("body");
  body.position = Vec3(0.0, 0.0, half_height(body));
  problem.bodies = {body};
  problem.obstacles = {{"ground", Vec3::Zero(), Vec3::UnitZ(), friction}};
  problem.gravity = {{0.0}, {Vec3(0.0, 0.0, -kGravity)}};
  return problem;
}

// Ways in which engines combine a pair's two coefficients, and what each would give.
std::string combined(double measured, double given, double other) {
  const struct {
    const char* words;
    double value;
  } ways[] = {{"the product of the two", given * other},
              {"their geometric mean", std::sqrt(given * other)},
              {"their mean", 0.5 * (given + other)},
              {"the other pair's", other}};
  for (const auto& way : ways) {
    if (std::abs(measured - way.value) < 0.05 * way.value) {
      return fmt::format(": that is {}", way.words);
    }
  }
  return "";
}

// Slides with 3 m/s, and is watched once its landing is over.
constexpr double kSpeed = 3.0, kFrom = 0.3, kTo = 0.8;  // m/s, s

// μ from the mean deceleration of body 0 along x, between two times.
double measured_friction(const Probe& probe, const Problem& problem) {
  const auto engine = probe.start(problem);
  const double from = advance_to(*engine, kFrom);
  const BodyMotion before = engine->body(0);
  const double to = advance_to(*engine, kTo);
  const BodyMotion after = engine->body(0);
  // Under a constant force the way is the mean of the two speeds times the time.
  const double way = after.position.x() - before.position.x();
  const double expected = 0.5 * (before.velocity.x() + after.velocity.x()) * (to - from);
  if (!(std::abs(way - expected) <= 0.05 * std::abs(expected) + 1e-3)) {
    throw Nonconformity(
        fmt::format("a sliding body comes {:.4g} m far where its own velocities make it {:.4g} m: "
                    "are positions "
                    "and velocities those of the same body, at the same time?",
                    way, expected));
  }
  return (before.velocity.x() - after.velocity.x()) / (kGravity * (to - from));
}

// How accurate an engine's friction is, the cases measure. An adapter is to blame for μ of another
// pair that has an effect, and for a factor that is the same whatever μ is. `problem` is that of a
// sliding body whose pair has the first μ, and others the second.
std::string check_pair(const Probe& probe, const std::string& pair,
                       const std::function<Problem(double, double)>& problem) {
  constexpr double kGiven = 0.3, kOthers[] = {0.8, 0.15};
  constexpr double kMore[] = {0.2, 0.25};  // all stop within a window
  constexpr double kOther = 0.2, kSame = 0.01, kUniform = 2e-3, kWild = 0.3;  // relative
  const double measured = measured_friction(probe, problem(kGiven, kOthers[0]));
  const double again = measured_friction(probe, problem(kGiven, kOthers[1]));
  // Of the usual ways to combine two coefficients the gentlest, the lesser or the larger of them,
  // would halve or double it.
  if (!(std::abs(measured - again) <= kOther * kGiven)) {
    throw Nonconformity(
        fmt::format("{} with μ = {} for this pair slides as with {:.4g} where others have {} and "
                    "as with {:.4g} "
                    "where they have {}{}: μ is that of the pair, not to be combined",
                    pair, kGiven, measured, kOthers[0], again, kOthers[1],
                    combined(measured, kGiven, kOthers[0])));
  }
  const double factor = measured / kGiven;
  if (!(std::abs(factor) > 1e-3)) {
    throw Nonconformity(fmt::format("{} is not slowed down where μ = {} was given", pair, kGiven));
  }
  double least = factor, most = factor;
  for (const double given : kMore) {
    const double one = measured_friction(probe, problem(given, kOthers[0])) / given;
    least = std::min(least, one);
    most = std::max(most, one);
  }
  const bool scaled = std::abs(factor - 1.0) > kSame && most - least < kUniform;
  if (scaled || !(std::abs(factor - 1.0) <= kWild)) {
    throw Nonconformity(
        fmt::format("{} slides as with {:.5g} where μ = {} was given{}", pair, measured, kGiven,
                    scaled ? fmt::format(", and with {:.4g} times as much at any μ: is it "
                                         "multiplied?",
                                         factor)
                           : ""));
  }
  return fmt::format("slides as with {:.6g} where {} was given", measured, kGiven);
}

void need_flat(const Probe& probe) {
  probe.need(probe.manifest().boxes || probe.manifest().point_masses || probe.manifest().meshes ||
                 probe.manifest().convex_meshes,
             "bodies that slide without rolling");
}

// Their mean over some steps.
void check_told_forces(Engine& engine, const Problem& problem) {
  constexpr int kSteps = 20;
  const double weight = problem.bodies[0].mass * kGravity;
  Vec3 force = Vec3::Zero();
  double deepest = 0.0;
  std::vector<ContactSample> all;
  for (int k = 0; k < kSteps; ++k) {
    engine.advance(1);
    const std::vector<ContactSample> now = engine.contacts();
    all.insert(all.end(), now.begin(), now.end());
  }
  for (const ContactSample& contact : all) {
    force += contact.normal_force * contact.normal + contact.friction_force;
    deepest = std::max(deepest, std::abs(contact.position.z()));
    if (contact.normal_force < 0.0 || contact.normal.z() < 0.0) {
      throw Nonconformity(fmt::format(
          "of a body at rest on the ground a contact tells the normal ({:.3g}, {:.3g}, {:.3g}) and "
          "a normal force of {:.4g} N: the normal points out of what is touched, the force acts "
          "along it and is not below 0",
          contact.normal.x(), contact.normal.y(), contact.normal.z(), contact.normal_force));
    }
  }
  const double share = force.z() / (kSteps * weight);
  if (std::abs(share + 1.0) <= kForces) {
    throw Nonconformity(
        "the contact forces of a body at rest pull it down: they have the wrong sign");
  }
  if (!(std::abs(share - 1.0) <= kForces)) {
    throw Nonconformity(fmt::format(
        "the contact forces of a body at rest carry {:.5g} of its weight of {:.4g} N (an impulse, "
        "which a step of {:.4g} s makes of it, would be {:.3g})",
        share, weight, engine.time_step(), engine.time_step()));
  }
  if (!(deepest <= 0.02)) {
    throw Nonconformity(fmt::format("a contact on the ground is told {:.3g} m from it", deepest));
  }
}

}  // namespace

std::string check_weight(const Probe& probe) {
  const Problem problem = on_ground(probe, 0.5);
  const auto engine = probe.start(problem);
  advance_to(*engine, 1.0);
  if (probe.manifest().contacts) check_told_forces(*engine, problem);
  const double time = static_cast<double>(engine->steps_done()) * engine->time_step();
  const BodyMotion motion = engine->body(0);
  const double height = half_height(problem.bodies[0]);
  const double rise = motion.position.z() - height;
  if (!(std::abs(rise) <= 0.2 * height + 0.005)) {
    const bool twice = std::abs(rise - height) <= 0.1 * height;
    throw Nonconformity(fmt::format(
        "a body that was put on the ground is {:.4g} m high after {:.3g} s where {:.4g} belongs{}",
        motion.position.z(), time, height,
        twice ? ": are edge lengths taken for half edges?" : ""));
  }
  return fmt::format("{:+.2g} m from where it was put, {:.2g} m/s", rise, motion.velocity.norm());
}

std::string check_friction(const Probe& probe) {
  need_flat(probe);
  return check_pair(probe, "a body on an obstacle", [&](double given, double other) {
    Problem problem = on_ground(probe, given);
    problem.friction = other;
    problem.bodies[0].velocity = Vec3(kSpeed, 0.0, 0.0);
    return problem;
  });
}

std::string check_pair_friction(const Probe& probe) {
  probe.need(probe.manifest().body_contact, "contact between bodies");
  probe.need(probe.manifest().boxes, "boxes");
  return check_pair(probe, "a body on another", [&](double given, double other) {
    Problem problem = on_ground(probe, other);
    problem.name = "a box on a heavy one";
    problem.friction = given;
    ProblemBody lower = probe.body("lower");
    lower.shape = BoxShape{{5.0, 0.8, 0.1}};
    lower.mass = 100.0;
    lower.position = Vec3(0.0, 0.0, 0.05);
    ProblemBody& upper = problem.bodies[0];
    upper.position = Vec3(-2.0, 0.03, 0.15);
    upper.velocity = Vec3(kSpeed, 0.0, 0.0);
    problem.bodies.push_back(lower);
    return problem;
  });
}

std::string check_single_pairs(const Probe& probe) {
  probe.need(probe.manifest().pair_friction, "friction of single pairs");
  need_flat(probe);
  return check_pair(probe, "a body on an obstacle, a pair of its own,",
                    [&](double given, double other) {
                      Problem problem = on_ground(probe, other);
                      problem.friction = other;
                      problem.bodies[0].velocity = Vec3(kSpeed, 0.0, 0.0);
                      problem.pair_friction = {{.body = 0, .other = 0, .friction = given}};
                      return problem;
                    });
}

std::string check_restitution(const Probe& probe) {
  probe.need(probe.manifest().restitution, "restitution");
  constexpr double kGiven = 0.5, kOff = 0.3, kFall = 0.2;  // off: relative, it may land on an edge
  Problem problem = on_ground(probe, 0.0);
  problem.bodies[0].position.z() += kFall;
  problem.restitution = kGiven;
  const auto engine = probe.start(problem);
  const double met = std::sqrt(2.0 * kGravity * kFall), landed = met / kGravity;
  double most = 0.0;
  while (static_cast<double>(engine->steps_done()) * engine->time_step() < 1.5 * landed) {
    engine->advance(1);
    most = std::max(most, engine->body(0).velocity.z());
  }
  if (!(std::abs(most / met - kGiven) <= kOff * kGiven)) {
    throw Nonconformity(
        fmt::format("a body that falls on the ground with {:.4g} m/s leaves it with {:.4g} of that "
                    "where a restitution of {:g} was given",
                    met, most / met, kGiven));
  }
  return fmt::format("leaves the ground with {:.4g} of its speed where {:g} was given", most / met,
                     kGiven);
}

}  // namespace stiction
