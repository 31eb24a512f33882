// SPDX-License-Identifier: GPL-3.0-or-later
// Motions without contact: a body's path is known whatever the engine's model of contact is.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "validation/engine/conformance/probe.h"

namespace stiction {

namespace {

constexpr double kExact =
    1e-5;  // m, m/s, rad: of numbers that are only passed on; single precision has 1e-7
constexpr double kDamped = 0.9;  // of the way: some engines damp all motion unless told otherwise
constexpr double kClose =
    2e-3;  // relative: of a motion; what a scheme of higher error is off in some steps
constexpr double kDegrees = 180.0 / std::numbers::pi;

std::string text(const Vec3& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x(), v.y(), v.z());
}

bool near(double value, double expected, double relative) {
  return std::abs(value - expected) <= relative * std::abs(expected);
}

// Three bodies far from each other, each with a pose and a velocity of its own; one where the engine
// knows no contact between bodies.
Problem apart(const Probe& probe) {
  Problem problem;
  problem.name = "bodies apart";
  const int count = probe.manifest().body_contact ? 3 : 1;
  for (int k = 0; k < count; ++k) {
    ProblemBody body = probe.body(fmt::format("body {}", k));
    body.position = Vec3(1.0 + 2.0 * k, -0.5 * k, 3.0 + k);
    body.velocity = Vec3(0.4 - 0.3 * k, 0.1 * (k + 1), -0.2);
    body.rotation = Eigen::AngleAxisd(0.3 + 0.4 * k, Vec3(1.0, 2.0, -0.5 * k).normalized());
    problem.bodies.push_back(body);
  }
  return problem;
}

// Which other body a told vector belongs to; −1: none.
int owner(const std::vector<Vec3>& expected, const Vec3& told, double tolerance) {
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if ((told - expected[k]).norm() <= tolerance) return static_cast<int>(k);
  }
  return -1;
}

void compare(const std::vector<Vec3>& expected, const std::vector<Vec3>& told, double tolerance,
             const std::string& what) {
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if ((told[k] - expected[k]).norm() <= tolerance) continue;
    const int other = owner(expected, told[k], tolerance);
    if (other >= 0) {
      throw Nonconformity(fmt::format(
          "the {} of body {} is told as that of body {}: bodies must keep the problem's order",
          what, other, k));
    }
    throw Nonconformity(fmt::format("the {} of body {} is told as {} where {} was given", what, k,
                                    text(told[k]), text(expected[k])));
  }
}

}  // namespace

std::string check_start(const Probe& probe) {
  const Problem problem = apart(probe);
  const auto engine = probe.start(problem);
  std::vector<Vec3> position, velocity, told_position, told_velocity;
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
    position.push_back(problem.bodies[k].position);
    velocity.push_back(problem.bodies[k].velocity);
    told_position.push_back(engine->body(k).position);
    told_velocity.push_back(engine->body(k).velocity);
    // body() tells the rotation from the initial pose.
    const Eigen::Quaterniond turned = engine->body(k).rotation;
    const double angle = 2.0 * std::atan2(turned.vec().norm(), std::abs(turned.w()));
    if (angle > kExact) {
      throw Nonconformity(fmt::format(
          "the rotation of body {} is told {:.3g} rad off that which was given: it is w, x, y, z, "
          "from the body's frame to the world's",
          k, angle));
    }
  }
  compare(position, told_position, kExact * 10.0, "position at the start");
  compare(velocity, told_velocity, kExact, "velocity at the start");
  return fmt::format("{} bodies stand where they were put", problem.bodies.size());
}

std::string check_velocity(const Probe& probe) {
  Problem problem = apart(probe);
  for (ProblemBody& body : problem.bodies) body.rotation.setIdentity();
  const auto engine = probe.start(problem);
  const double time = advance_to(*engine, 0.5);
  std::vector<Vec3> expected, told;
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
    expected.push_back(problem.bodies[k].position + time * problem.bodies[k].velocity);
    told.push_back(engine->body(k).position);
  }
  const ProblemBody& first = problem.bodies[0];
  const double share =
      (told[0] - first.position).dot(first.velocity) / (time * first.velocity.squaredNorm());
  if (std::abs(share) < 1e-6) {
    throw Nonconformity(
        fmt::format("after {:.4g} s a body thrown at {:.3g} m/s has not moved: did time advance?",
                    time, first.velocity.norm()));
  }
  if (near(share, 0.5, kClose)) {
    throw Nonconformity(fmt::format(
        "bodies move half as far as their velocity takes them in {:.4g} s: is each step half as "
        "long as the time step that is told, {:.6g} s?",
        time, engine->time_step()));
  }
  if (!(share >= kDamped && share <= 1.0 + kClose) && owner(expected, told[0], 1e-3) < 0) {
    throw Nonconformity(fmt::format(
        "without any force a body moves {:.6g} times as far as its velocity takes it in {:.4g} s: "
        "is there hidden damping, or another time step than the {:.6g} s that is told?",
        share, time, engine->time_step()));
  }
  compare(expected, told, kClose * 0.5 + (1.0 - std::min(share, 1.0)), "position after 0.5 s");
  return fmt::format("moves {:.9g} times as far as its velocity says", share);
}

std::string check_free_fall(const Probe& probe) {
  Problem problem;
  problem.name = "free fall";
  problem.bodies = {probe.body("body")};
  const Vec3 gravity(1.0, -2.0, -9.0);
  problem.gravity = {{0.0}, {gravity}};
  const auto engine = probe.start(problem);
  const double time = advance_to(*engine, 0.5);
  const BodyMotion motion = engine->body(0);
  const double path = motion.position.dot(gravity) / gravity.squaredNorm() / (0.5 * time * time);
  const double speed = motion.velocity.dot(gravity) / gravity.squaredNorm() / time;
  const double across =
      (motion.position - motion.position.dot(gravity) / gravity.squaredNorm() * gravity).norm();
  if (near(speed, 2.0, 0.01)) {
    throw Nonconformity(
        fmt::format("falls with {:.4g} m/s² where gravity is {:.4g}: is gravity "
                    "applied twice?",
                    speed * gravity.norm(), gravity.norm()));
  }
  if (near(speed, -1.0, 0.01)) throw Nonconformity("falls upwards: gravity has the wrong sign");
  if (std::abs(speed) < 1e-6) {
    throw Nonconformity(
        fmt::format("after {:.4g} s in the air it has no speed: did time advance, "
                    "and does gravity act?",
                    time));
  }
  // A scheme of first order is off by a step at the start or at the end.
  const double step = engine->time_step() / time;
  if (!(std::abs(speed - 1.0) <= kClose + step) || !(std::abs(path - 1.0) <= kClose + 2.0 * step)) {
    throw Nonconformity(fmt::format(
        "after {:.4g} s of free fall it has {:.6g} of the speed g t and {:.6g} of the way ½ g t²",
        time, speed, path));
  }
  if (across > kClose * motion.position.norm()) {
    throw Nonconformity(fmt::format("falls {:.3g} m beside the direction of gravity", across));
  }
  // Claimed: after n steps n (n + 1)/2 Δt² g, to round-off.
  const auto steps = static_cast<double>(engine->steps_done());
  const double exact = (steps + 1.0) / steps;
  if (engine->symplectic_euler() && !(std::abs(path / exact - 1.0) <= 1e-12 * steps)) {
    throw Nonconformity(fmt::format(
        "it says that it steps by symplectic Euler, but falls {:.9g} of the way ½ g t² in {:.0f} "
        "steps where that gives {:.9g}",
        path, steps, exact));
  }
  return fmt::format("{:.6g} of g t, {:.6g} of ½ g t²", speed, path);
}

std::string check_spin(const Probe& probe) {
  probe.need(probe.manifest().spin, "bodies that turn");
  Problem problem;
  problem.name = "a spinning body";
  problem.bodies = {probe.body("body")};
  ProblemBody& body = problem.bodies[0];
  // It lies on its side, so that the world's axis z is a principal axis but not the body's own z.
  body.rotation = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitX());
  body.angular_velocity = Vec3(0.0, 0.0, 0.8);
  const auto engine = probe.start(problem);
  const Vec3 told = engine->body(0).angular_velocity;
  const double ratio = told.z() / 0.8;
  if (near(ratio, kDegrees, 0.01) || near(ratio, 1.0 / kDegrees, 0.01)) {
    throw Nonconformity(
        fmt::format("an angular velocity of 0.8 rad/s is told as {:.6g}: are these "
                    "degrees, where radians belong?",
                    told.z()));
  }
  if ((told - body.angular_velocity).norm() > kExact) {
    throw Nonconformity(
        fmt::format("an angular velocity of (0, 0, 0.8) rad/s in the world's frame "
                    "is told as {}",
                    text(told)));
  }
  const double time = advance_to(*engine, 0.5);
  const Eigen::AngleAxisd turned(engine->body(0).rotation);
  const Vec3 turn = turned.angle() * turned.axis();
  const double share = turn.z() / (0.8 * time);
  if (near(share, kDegrees, 0.01) || near(share, 1.0 / kDegrees, 0.01)) {
    throw Nonconformity(
        fmt::format("turns by {:.4g} rad in {:.4g} s where 0.8 rad/s gives {:.4g}: "
                    "are degrees taken for radians?",
                    turn.z(), time, 0.8 * time));
  }
  if (near(share, -1.0, 0.01)) {
    throw Nonconformity(
        "turns the other way: the rotation goes from the body's frame to the world's");
  }
  // Some engines damp rotations unless told otherwise: then it turns less, but about that axis.
  if (!(share >= kDamped && share <= 1.02) || Vec3(turn.x(), turn.y(), 0.0).norm() > 0.01 * time) {
    throw Nonconformity(
        fmt::format("spun with (0, 0, 0.8) rad/s it has turned by {} rad in {:.4g} s, "
                    "about the world's axes",
                    text(turn), time));
  }
  return fmt::format("turns {:.6g} times as far as its angular velocity says", share);
}

std::string check_loads(const Probe& probe) {
  Problem problem;
  problem.name = "a loaded body";
  problem.bodies = {probe.body("body")};
  const Vec3 force(0.5, -1.0, 2.0);
  Load load{.body = 0, .force = {{0.0}, {force}}};
  const bool spin = probe.manifest().spin;
  if (spin) load.couple = {{0.0}, {Vec3(0.0, 0.0, 2e-3)}};
  problem.loads = {load};
  const auto engine = probe.start(problem);
  const double time = advance_to(*engine, 0.5);
  const BodyMotion motion = engine->body(0);
  const double share =
      problem.bodies[0].mass * motion.velocity.dot(force) / (force.squaredNorm() * time);
  const double step = engine->time_step() / time;
  if (!(share >= kDamped && share <= 1.0 + kClose + step)) {
    throw Nonconformity(fmt::format("a force gives it {:.6g} of the momentum F t", share));
  }
  if (!spin) return fmt::format("{:.6g} of F t", share);
  const Momenta momenta = engine->momenta();
  const Vec3 about_centre = momenta.angular - motion.position.cross(momenta.linear);
  const double turned = about_centre.z() / (2e-3 * time);
  if (!(turned >= kDamped && turned <= 1.01 + step)) {
    throw Nonconformity(
        fmt::format("a couple gives it {:.6g} of the angular momentum τ t", turned));
  }
  return fmt::format("{:.6g} of F t, {:.6g} of τ t", share, turned);
}

std::string check_sines(const Probe& probe) {
  probe.need(probe.manifest().oscillation, "sines over time");
  constexpr double kAmplitude = 3.0, kFrequency = 2.0, kBegins = 0.0625;  // m/s², Hz, s
  Problem problem;
  problem.name = "gravity that swings";
  problem.bodies = {probe.body("body")};
  problem.gravity = {{0.0}, {Vec3(0.0, 0.0, -1.0)}, {}};
  problem.gravity.oscillation = {.amplitude = Vec3(kAmplitude, 0.0, 0.0),
                                 .frequency = kFrequency,
                                 .begins = kBegins,
                                 .full_from = kBegins};
  const auto engine = probe.start(problem);
  const double time = advance_to(*engine, 0.25);
  const double omega = 2.0 * std::numbers::pi * kFrequency, most = 2.0 * kAmplitude / omega;
  const double expected = kAmplitude / omega * (1.0 - std::cos(omega * (time - kBegins)));
  const Vec3 velocity = engine->body(0).velocity;
  // A scheme of first order is off by a step of the strongest acceleration.
  const double allowed = kClose * most + kAmplitude * engine->time_step();
  if (!(std::abs(velocity.x() - expected) <= allowed)) {
    throw Nonconformity(fmt::format(
        "under a gravity that swings by {:g} m/s² at {:g} Hz from {:g} s on it moves with {:.5g} "
        "m/s at {:.4g} s where {:.5g} belongs",
        kAmplitude, kFrequency, kBegins, velocity.x(), time, expected));
  }
  if (!(std::abs(velocity.z() / time + 1.0) <= kClose + engine->time_step() / time)) {
    throw Nonconformity(
        fmt::format("the steady part of a gravity that swings gives it {:.5g} of the speed g t",
                    -velocity.z() / time));
  }
  return fmt::format("{:+.2g} m/s off its velocity under a sine", velocity.x() - expected);
}

}  // namespace stiction
