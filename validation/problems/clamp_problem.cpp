// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/clamp_problem.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "reference/meshes/box_mesh.h"
#include "validation/observe/observe.h"

namespace stiction {

namespace {

Motion closing(double way) { return {{0.0, kClosed}, {Vec3::Zero(), Vec3(way, 0.0, 0.0)}}; }

// Shift of bars across the row, and of boxes in turn to either side: neighbours then stand 2 mm
// apart, so that no vertex lies on another one or on an edge. Flush, nothing is shifted.
double shift(const ClampSetup& setup) { return setup.flush ? 0.0 : 1e-3; }

// A bar on the side `side` (−1 left, 1 right) of a row that ends at x = ± `reach`.
ProblemBody bar(const ClampSetup& setup, double side, double reach) {
  ProblemBody body;
  body.name = side < 0 ? "left bar" : "right bar";
  body.shape = MeshShape{reference::box_mesh(setup.bar, setup.bar_cells)};
  body.mass = setup.box_mass * setup.bar.prod() / std::pow(setup.width, 3);
  body.elasticity = setup.elasticity;
  body.elasticity.youngs_modulus *= setup.bar_stiffness;
  body.position =
      Vec3(side * (reach + 0.5 * setup.bar.x()), shift(setup), -0.5 * side * setup.offset);
  body.held = HeldPart{Vec3(side * 0.5 * setup.bar.x(), 0, 0), Vec3(-side, 0, 0)};
  body.motion = closing(-side * setup.squeeze);
  return body;
}

}  // namespace

Problem clamp_problem(const ClampSetup& setup) {
  const double reach = 0.5 * setup.width * setup.boxes;
  Problem problem;
  problem.name = "clamp";
  for (int k = 0; k < setup.boxes; ++k) {
    ProblemBody box;
    box.name = "box " + std::to_string(k + 1);
    box.shape = MeshShape{reference::box_mesh(Vec3::Constant(setup.width), setup.box_cells)};
    box.mass = setup.box_mass;
    box.elasticity = setup.elasticity;
    box.position = Vec3((k + 0.5) * setup.width - reach, shift(setup) * (k % 2 == 0 ? -1 : 1), 0);
    problem.bodies.push_back(box);
  }
  if (setup.rigid) {
    for (const double side : {-1.0, 1.0}) {
      problem.obstacles.push_back({.name = side < 0 ? "left jaw" : "right jaw",
                                   .point = Vec3(side * reach, 0, 0),
                                   .normal = Vec3(-side, 0, 0),
                                   .friction = setup.friction,
                                   .motion = closing(-side * setup.squeeze)});
    }
  } else {
    for (const double side : {-1.0, 1.0}) problem.bodies.push_back(bar(setup, side, reach));
  }
  problem.friction = setup.friction;
  problem.gravity = {{kFallFrom, setup.fall_full}, {Vec3::Zero(), Vec3(0, 0, -setup.fall)}};
  return problem;
}

JointForce joint_force(const Engine& engine, const ClampSetup& setup, int joint) {
  const auto boxes = static_cast<std::size_t>(setup.boxes);
  const auto after = static_cast<std::size_t>(joint);  // the box right of the joint, if there is
  const bool at_left_jaw = after == 0;
  const bool at_jaw = at_left_jaw || after == boxes;
  const std::size_t left_body = at_left_jaw ? boxes : after - 1;
  const std::size_t right_body = after == boxes ? boxes + 1 : after;
  JointForce sum;
  double friction = 0.0;
  for (const ContactSample& contact : engine.contacts()) {
    bool on_left = false;
    if (!contact.against_body) {
      if (!at_jaw || contact.obstacle != (at_left_jaw ? 0u : 1u)) continue;
      on_left = !at_left_jaw;
    } else {
      on_left = contact.body == left_body && contact.obstacle == right_body;
      if (!on_left && (contact.body != right_body || contact.obstacle != left_body)) continue;
    }
    const double normal = contact.normal_force;
    (on_left ? sum.own_left : sum.own_right) += normal * contact.normal + contact.friction_force;
    sum.normal += normal;
    sum.height += normal * contact.position.z();
    sum.across += normal * contact.position.x();
    sum.lift += (contact.body < boxes ? 1.0 : -1.0) * normal * contact.normal.z();
    sum.along += std::abs(contact.friction_force.z());
    friction += contact.friction_force.norm();
    if (contact.body >= boxes) continue;
    sum.own_normal += normal;
    sum.own_height += normal * contact.position.z();
  }
  sum.on_left = sum.own_left - sum.own_right;
  if (sum.normal > 0.0) {
    sum.height /= sum.normal;
    sum.across /= sum.normal;
    sum.lift /= sum.normal;
    sum.along /= friction;
  }
  if (sum.own_normal > 0.0) sum.own_height /= sum.own_normal;
  return sum;
}

double clamp_force(const Engine& engine, const ClampSetup& setup) {
  return 0.5 *
         (joint_force(engine, setup, 0).normal + joint_force(engine, setup, setup.boxes).normal);
}

ClampProbe probe_clamp(CaseRun& run, const ClampSetup& setup, const Accuracy& accuracy,
                       bool twice) {
  constexpr double kCreeps = 1e-4;              // m/s
  constexpr double kSags = 2e-3, kLeft = 2e-2;  // m
  constexpr double kWindow = 0.3;               // s
  const auto simulation = run.simulate(clamp_problem(setup), accuracy);
  const Engine& engine = simulation->engine();
  const auto fall = [&] { return -engine.body(0).velocity.z(); };
  ClampProbe probe;
  simulation->advance_to(kFallFrom);
  const double start = pose_of(engine, 0).height;
  probe.unloaded = clamp_force(engine, setup);
  simulation->advance_to(setup.fall_full + kWindow);
  probe.force = clamp_force(engine, setup);
  const JointForce left = joint_force(engine, setup, 0);
  const JointForce right = joint_force(engine, setup, setup.boxes);
  probe.slope = (left.height - right.height) / (right.across - left.across);
  probe.lift = right.lift;
  probe.along = right.along;
  // From the present on until then.
  const auto watch = [&](double end) {
    const double before = pose_of(engine, 0).height, speed = fall();
    simulation->advance_to(end);
    const double after = pose_of(engine, 0).height;
    probe.creep = (before - after) / kWindow;
    probe.excess = fall() - speed;
    probe.holds =
        (std::abs(probe.creep) < kCreeps || probe.excess < 0.0) && std::abs(after - start) < kSags;
  };
  if (std::abs(pose_of(engine, 0).height - start) > kLeft) return probe;  // out of the clamp
  watch(setup.fall_full + 2.0 * kWindow);
  if (!twice || !probe.holds) return probe;
  const double end = 2.0 * (setup.fall_full + 2.0 * kWindow);
  simulation->advance_to(end - kWindow);
  watch(end);
  return probe;
}

namespace {

// Least force of a clamp whose forces fall to a fold at `fails`, by the two nearest that hold; no number
// if there is but one.
double force_at_fold(const std::map<double, ClampProbe>& probes, double fails) {
  double near = 0.0, next = 0.0;  // roots of distances
  double of_near = std::nan(""), of_next = std::nan("");
  for (const auto& [squeeze, probe] : probes) {
    if (!probe.holds) continue;
    const double root = std::sqrt(std::abs(squeeze - fails));
    if (std::isnan(of_near) || root < near) {
      next = std::exchange(near, root);
      of_next = std::exchange(of_near, probe.force);
    } else if (std::isnan(of_next) || root < next) {
      next = root;
      of_next = probe.force;
    }
  }
  return of_near - near * (of_next - of_near) / (next - near);
}

// How the excess grows with the way, by the two farthest apart of those that fail; no number if there is
// but one. 1/s.
double slope_of(const std::map<double, ClampProbe>& probes) {
  std::vector<std::pair<double, double>> known;
  for (const auto& [squeeze, probe] : probes) {
    if (!probe.holds && probe.excess > 0.0) known.emplace_back(squeeze, probe.excess);
  }
  if (known.empty()) return std::nan("");
  return std::abs((known.back().second - known.front().second) /
                  (known.back().first - known.front().first));
}

}  // namespace

ClampThreshold clamp_threshold(CaseRun& run, ClampSetup setup, const ClampSearch& search,
                               const Accuracy& accuracy) {
  std::map<double, ClampProbe> probes;  // by squeeze
  const Bracket bracket = find_threshold_near(
      search.guess, -search.step, search.reach, search.width,
      [&](double squeeze) {
        setup.squeeze = squeeze;
        const ClampProbe& probe = probes[squeeze] = probe_clamp(run, setup, accuracy);
        return Holding(probe.holds, probe.excess);
      },
      search.slope);
  ClampThreshold result{.holds = {},
                        .fails = {},
                        .squeeze = bracket.holds,
                        .slope = slope_of(probes),
                        .evaluations = bracket.evaluations,
                        .upper = bracket.holds,
                        .lower = bracket.holds};
  if (std::isnan(bracket.holds)) return result;
  result.holds = probes.at(bracket.holds);
  result.fails = probes.at(bracket.fails);
  result.upper = result.holds.force;
  // Of two numbers the larger; of a number and none that number.
  result.lower = std::fmax(result.fails.force, force_at_fold(probes, bracket.fails));
  return result;
}

Pose pose_of(const Engine& engine, std::size_t body) {
  const BodyMotion motion = engine.body(body);
  // Signed angle about y of the twist part of the rotation.
  const double angle = 2.0 * std::atan2(motion.rotation.y(), motion.rotation.w());
  const double turn = std::remainder(angle, 2.0 * std::numbers::pi);
  return {motion.position.z(), turn * 180.0 / std::numbers::pi};
}

void ClampSeries::sample(const Simulation& simulation) {
  const Engine& engine = simulation.engine();
  const Pose pose = pose_of(engine, 0);
  time_.push_back(simulation.time());
  kinetic_.push_back(engine.kinetic_energy());
  slip_.push_back(fastest_slip(engine));
  height_.push_back(pose.height);
  angle_.push_back(pose.angle);
}

void ClampSeries::add_to(CaseRun& run) const {
  run.add({"kinetic energy", "J", "time", "s", time_, kinetic_});
  run.add({"fastest contact slip", "m/s", "time", "s", time_, slip_});
  run.add({"height", "m", "time", "s", time_, height_});
  run.add({"rotation", "°", "time", "s", time_, angle_});
}

void advance_sampled(Simulation& simulation, double end, int samples, ClampSeries& series) {
  const double begin = simulation.time();
  for (int k = 1; k <= samples; ++k) {
    simulation.advance_to(begin + (end - begin) * k / samples);
    series.sample(simulation);
  }
}

}  // namespace stiction
