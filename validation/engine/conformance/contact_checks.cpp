// SPDX-License-Identifier: GPL-3.0-or-later
// What an adapter makes of contact: whose force it is, in which units, and which μ.
#include <fmt/format.h>

#include <cmath>

#include "validation/engine/conformance/probe.h"

namespace stiction {

namespace {

constexpr double kGravity = 9.81;   // m/s²
constexpr double kForces = 0.02;    // relative: of a weight at rest, which may still ring a little
constexpr double kFriction = 0.01;  // relative: of a mean deceleration
constexpr double kSpeed = 1.0;      // m/s

struct HalfHeight {
  double operator()(const BoxShape& box) const { return 0.5 * box.size.z(); }
  double operator()(const BallShape& ball) const { return ball.radius; }
  double operator()(const PointShape&) const { return 0.0; }
  double operator()(const MeshShape& shape) const { return -shape.mesh.vertices.row(2).minCoeff(); }
};

double half_height(const ProblemBody& body) { return std::visit(HalfHeight{}, body.shape); }

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
              {"the other pair's", other},
              {"its square", given * given},
              {"its root", std::sqrt(given)},
              {"twice as much", 2.0 * given}};
  for (const auto& way : ways) {
    if (std::abs(measured - way.value) < kFriction * way.value) {
      return fmt::format(" That is {}.", way.words);
    }
  }
  return fmt::format(" That is {:.4g} times as much.", measured / given);
}

[[noreturn]] void refuse_friction(double measured, double given, double other,
                                  const std::string& pair) {
  throw Nonconformity(
      fmt::format("{} slides as with μ = {:.5g} where {} was given for this pair, {} for others.{}",
                  pair, measured, given, other, combined(measured, given, other)));
}

// μ from the mean deceleration of a body's centre along x, between two times.
double measured_friction(Engine& engine, std::size_t body) {
  const double from = advance_to(engine, 0.05);
  const double before = engine.body(body).velocity.x();
  const double to = advance_to(engine, 0.15);
  return (before - engine.body(body).velocity.x()) / (kGravity * (to - from));
}

void need_flat(const Probe& probe) {
  probe.need(probe.manifest().boxes || probe.manifest().point_masses || probe.manifest().meshes ||
                 probe.manifest().convex_meshes,
             "bodies that slide without rolling");
}

void check_told_forces(const Engine& engine, const Problem& problem) {
  const double weight = problem.bodies[0].mass * kGravity;
  Vec3 force = Vec3::Zero();
  double deepest = 0.0;
  for (const ContactSample& contact : engine.contacts()) {
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
  const double share = force.z() / weight;
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
  const double time = advance_to(*engine, 1.0);
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
  // Mean over the last tenth of a second, as an elastic body may still ring.
  if (probe.manifest().contacts) check_told_forces(*engine, problem);
  return fmt::format("{:+.2g} m from where it was put, {:.2g} m/s", rise, motion.velocity.norm());
}

std::string check_friction(const Probe& probe) {
  need_flat(probe);
  constexpr double kGiven = 0.3, kOther = 0.8;
  Problem problem = on_ground(probe, kGiven);
  problem.friction = kOther;
  problem.bodies[0].velocity = Vec3(kSpeed, 0.0, 0.0);
  const auto engine = probe.start(problem);
  const double measured = measured_friction(*engine, 0);
  if (!(std::abs(measured - kGiven) <= kFriction * kGiven)) {
    refuse_friction(measured, kGiven, kOther, "a body on an obstacle");
  }
  return fmt::format("slides as with {:.6g} where {} was given", measured, kGiven);
}

std::string check_pair_friction(const Probe& probe) {
  probe.need(probe.manifest().body_contact, "contact between bodies");
  probe.need(probe.manifest().boxes, "boxes");
  constexpr double kGiven = 0.3, kGround = 0.9;
  Problem problem = on_ground(probe, kGround);
  problem.name = "a box on a heavy one";
  problem.friction = kGiven;
  ProblemBody lower = probe.body("lower");
  lower.shape = BoxShape{{1.0, 0.8, 0.1}};
  lower.mass = 40.0;
  lower.position = Vec3(0.0, 0.0, 0.05);
  ProblemBody& upper = problem.bodies[0];
  upper.position = Vec3(-0.2, 0.03, 0.15);
  upper.velocity = Vec3(kSpeed, 0.0, 0.0);
  problem.bodies.push_back(lower);
  const auto engine = probe.start(problem);
  const double measured = measured_friction(*engine, 0);
  if (!(std::abs(measured - kGiven) <= kFriction * kGiven)) {
    refuse_friction(measured, kGiven, kGround, "a body on another");
  }
  return fmt::format("slides as with {:.6g} where {} was given", measured, kGiven);
}

}  // namespace stiction
