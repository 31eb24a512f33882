// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/stability/reference_frame.h"

#include <utility>

#include "validation/engine/engine.h"

namespace stiction {

namespace {

// What a mirror makes of a body's own frame, so that its rotation stays one: x → −x.
Eigen::Matrix3d own_mirror() { return Vec3(-1.0, 1.0, 1.0).asDiagonal(); }

struct SeenShape {
  const ReferenceFrame& frame;
  Shape operator()(BoxShape box) const {
    box.size *= frame.length;
    return box;
  }
  Shape operator()(BallShape ball) const {
    ball.radius *= frame.length;
    return ball;
  }
  Shape operator()(MeshShape shape) const {
    shape.mesh.vertices *= frame.length;
    if (frame.mirrors()) {
      shape.mesh.vertices.row(0) *= -1.0;
      shape.mesh.tetrahedra.row(2).swap(shape.mesh.tetrahedra.row(3));
    }
    return shape;
  }
  Shape operator()(const PointShape& point) const { return point; }
};

std::vector<double> times(std::vector<double> all, double factor) {
  for (double& one : all) one *= factor;
  return all;
}

template <class Map>
std::vector<Vec3> mapped(std::vector<Vec3> all, const Map& map) {
  for (Vec3& one : all) one = map(one);
  return all;
}

}  // namespace

Problem ReferenceFrame::seen(const Problem& problem) const {
  const bool drifts = !drift.isZero(0.0);
  if (drifts && problem.drag.rate > 0.0) {
    throw NotApplicable("the medium that the scene settles in does not drift along");
  }
  const double speed = length / time, acceleration = speed / time;
  const auto point = [&](const Vec3& x) -> Vec3 { return length * turned(x) + shift; };
  const auto vector = [&](double factor) {
    return [this, factor](const Vec3& v) -> Vec3 { return factor * turned(v); };
  };
  const auto couple = [&](const Vec3& v) -> Vec3 { return energy() * axial(v); };
  const auto swung = [&](Oscillation one, const auto& map) {
    one.amplitude = map(one.amplitude);
    one.frequency /= time;
    one.begins *= time;
    one.full_from *= time;
    return one;
  };
  const auto moved = [&](Motion motion) {
    motion.oscillation = swung(motion.oscillation, vector(length));
    motion.time = times(std::move(motion.time), time);
    motion.offset = mapped(std::move(motion.offset), vector(length));
    motion.velocity = speed * turned(motion.velocity) + drift;
    return motion;
  };
  const auto own = [&](const Vec3& v) -> Vec3 { return mirrors() ? Vec3(own_mirror() * v) : v; };

  Problem there = problem;
  for (ProblemBody& body : there.bodies) {
    body.shape = std::visit(SeenShape{*this}, body.shape);
    body.mass *= mass;
    body.elasticity.youngs_modulus *= mass / (length * time * time);
    body.elasticity.damping_time *= time;
    body.position = point(body.position);
    if (mirrors()) {
      const Eigen::Matrix3d turned_body = turn * body.rotation.toRotationMatrix() * own_mirror();
      body.rotation = Eigen::Quaterniond(turned_body);
    } else if (!turn.isIdentity(0.0)) {
      body.rotation = (Eigen::Quaterniond(turn) * body.rotation).normalized();
    }
    body.velocity = speed * turned(body.velocity) + drift;
    body.angular_velocity = axial(body.angular_velocity) / time;
    if (body.held) {
      body.held->point = length * own(body.held->point);
      body.held->normal = own(body.held->normal);
      body.motion = moved(body.motion);
    }
  }
  for (Obstacle& obstacle : there.obstacles) {
    obstacle.point = point(obstacle.point);
    obstacle.normal = turned(obstacle.normal);
    obstacle.motion = moved(obstacle.motion);
  }
  there.gravity.time = times(std::move(there.gravity.time), time);
  there.gravity.acceleration = mapped(std::move(there.gravity.acceleration), vector(acceleration));
  there.gravity.oscillation = swung(there.gravity.oscillation, vector(acceleration));
  there.drag.rate /= time;
  there.drag.full_until *= time;
  there.drag.ends *= time;
  for (Load& load : there.loads) {
    load.force.time = times(std::move(load.force.time), time);
    load.force.value = mapped(std::move(load.force.value), vector(force()));
    load.force.oscillation = swung(load.force.oscillation, vector(force()));
    load.couple.oscillation = swung(load.couple.oscillation, couple);
    load.couple.time = times(std::move(load.couple.time), time);
    load.couple.value = mapped(std::move(load.couple.value), couple);
  }
  for (Spring& spring : there.springs) {
    spring.anchor = point(spring.anchor);
    spring.anchor_velocity = speed * turned(spring.anchor_velocity) + drift;
    spring.axis = turned(spring.axis);
    spring.stiffness *= mass / (time * time);
  }
  there.duration *= time;
  return there;
}

Vec3 ReferenceFrame::position_back(const Vec3& x, double seen_time) const {
  return turned_back(x - shift - drift * seen_time) / length;
}

Vec3 ReferenceFrame::velocity_back(const Vec3& v) const {
  return turned_back(v - drift) / (length / time);
}

Eigen::Quaterniond ReferenceFrame::rotation_back(const Eigen::Quaterniond& rotation) const {
  if (turn.isIdentity(0.0)) return rotation;
  return Eigen::Quaterniond(Eigen::Matrix3d(turn.transpose() * rotation.toRotationMatrix() * turn));
}

}  // namespace stiction
