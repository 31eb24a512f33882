// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "validation/user/problem_keys.h"
#include "validation/user/read_motion.h"
#include "validation/user/reading.h"
#include "validation/user/surface_shape.h"

namespace stiction {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

MeshShape read_mesh(TomlTable& table) {
  const std::vector<Vector3d> vertices = table.vectors("vertices");
  MeshShape shape;
  shape.mesh.vertices.resize(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    shape.mesh.vertices.col(static_cast<Eigen::Index>(v)) = vertices[v];
  }
  shape.mesh.tetrahedra = table.tetrahedra("tetrahedra");
  if (shape.mesh.tetrahedra.cols() == 0) {
    table.refuse("tetrahedra", "a mesh needs at least one tetrahedron");
  }
  if (shape.mesh.tetrahedra.maxCoeff() >= shape.mesh.vertices.cols()) {
    table.refuse("tetrahedra", fmt::format("there is no vertex {}; there are {}, counted from 0",
                                           shape.mesh.tetrahedra.maxCoeff(), vertices.size()));
  }
  return shape;
}

Shape read_shape(TomlTable& table) {
  const std::string shape = table.text("shape");
  if (shape == "box") {
    const Vector3d size = table.vector("size");
    if (!(size.array() > 0.0).all()) table.refuse("size", "a box needs three positive edges");
    return BoxShape{size};
  }
  if (shape == "ball") {
    const double radius = table.number("radius");
    if (!(radius > 0.0)) table.refuse("radius", "'radius' must be positive");
    return BallShape{radius};
  }
  if (shape == "mesh") return read_mesh(table);
  if (shape == "surface") return read_surface(table);
  if (shape == "point") return PointShape{};
  table.refuse("shape",
               "there is no shape '" + shape + "'; there are: box, ball, mesh, surface, point");
}

// How far a turned shape reaches along a unit vector from its centre (a mesh's origin), m.
double reach(const Shape& shape, const Matrix3d& turned, const Vector3d& along) {
  const Vector3d own = turned.transpose() * along;
  if (const auto* const box = std::get_if<BoxShape>(&shape)) {
    return 0.5 * own.cwiseAbs().dot(box->size);
  }
  if (const auto* const ball = std::get_if<BallShape>(&shape)) return ball->radius;
  if (const auto* const mesh = std::get_if<MeshShape>(&shape)) {
    return (own.transpose() * mesh->mesh.vertices).maxCoeff();
  }
  return 0.0;
}

Eigen::Quaterniond read_rotation(TomlTable& table) {
  if (!table.has("rotation")) return Eigen::Quaterniond::Identity();
  if (!table.is_table("rotation")) {
    table.refuse("rotation", "'rotation' must be like { axis = [0, 0, 1], angle_deg = 30 }");
  }
  TomlTable rotation = table.table("rotation", problem_keys::rotation());
  const Vector3d axis = read_direction(rotation, "axis");
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(rotation.number("angle_deg") * kDegree, axis));
  rotation.finish();
  return turn;
}

// Where a body is put down: the frame (downhill, across, up) of an obstacle, and a point of the
// surface; of another body the frame of what that stands on, and its highest point above its middle.
struct Seat {
  UserSupport support{};
  Vector3d point = Vector3d::Zero();
  Matrix3d frame = Matrix3d::Identity();
  std::optional<Vector3d> downhill{};
};

Seat obstacle_seat(const UserProblem& user, std::size_t number) {
  const Obstacle& obstacle = user.problem.obstacles[number];
  const Vector3d& downhill = user.downhill[number];
  Seat seat{{number, std::nullopt}, obstacle.point, {}, {}};
  if (!user.level[number]) seat.downhill = downhill;
  seat.frame << downhill, obstacle.normal.cross(downhill), obstacle.normal;
  return seat;
}

Seat body_seat(const UserProblem& user, std::size_t number) {
  const ProblemBody& below = user.problem.bodies[number];
  const std::optional<std::size_t> obstacle = user.supports[number].obstacle;
  Seat seat = obstacle ? obstacle_seat(user, *obstacle) : Seat{};
  seat.support.body = number;
  const Vector3d up = seat.frame.col(2);
  seat.point = below.position + reach(below.shape, below.rotation.toRotationMatrix(), up) * up;
  return seat;
}

Seat read_seat(TomlTable& table, const Reading& reading) {
  const Partner support = find_partner(table, "rests_on", reading);
  return support.is_body ? body_seat(reading.user, support.index)
                         : obstacle_seat(reading.user, support.index);
}

void put_down(TomlTable& table, Reading& reading, ProblemBody& body) {
  const Seat seat = read_seat(table, reading);
  const Eigen::Quaterniond own =
      Eigen::AngleAxisd(table.number("yaw_deg", 0.0) * kDegree, Vector3d::UnitZ()) *
      read_rotation(table);
  body.rotation = Eigen::Quaterniond(seat.frame) * own;
  // A yaw does not change it; without more it is free of the turn's rounding.
  const Matrix3d tilt = table.has("rotation") ? own.toRotationMatrix() : Matrix3d::Identity();
  const double height = reach(body.shape, tilt, -Vector3d::UnitZ());
  const Vector3d offset = table.vector("offset", Vector3d::Zero());
  body.position = seat.point + height * seat.frame.col(2);
  if (!offset.isZero(0.0)) body.position += seat.frame * offset;
  if (table.has("speed_downhill")) {
    if (!seat.downhill) {
      table.refuse("speed_downhill",
                   "what it rests on is level, or stands on no obstacle: nothing is downhill, but "
                   "where the obstacle is given an 'azimuth_deg'");
    }
    body.velocity = table.number("speed_downhill") * *seat.downhill;
  }
  reading.user.supports.push_back(seat.support);
}

void read_pose(TomlTable& table, Reading& reading, ProblemBody& body) {
  if (table.has("rests_on")) return put_down(table, reading, body);
  body.position = table.vector("position");
  body.rotation = read_rotation(table);
  body.velocity = table.vector("velocity", Vector3d::Zero());
  reading.user.supports.emplace_back();
}

std::string text_of(const Vector3d& v) {
  return fmt::format("({:g}, {:g}, {:g})", v.x(), v.y(), v.z());
}

// Of a box around it, from its origin, along its own axes, m.
Vector3d most(const Shape& shape, double sign) {
  Vector3d corner;
  for (int k = 0; k < 3; ++k) {
    corner[k] = sign * reach(shape, Matrix3d::Identity(), sign * Vector3d::Unit(k));
  }
  return corner;
}

// Before it is meshed: no mesh of it reaches farther.
void refuse_held_beside(TomlTable& held, const ProblemBody& body) {
  const HeldPart& part = *body.held;
  const double lowest = -reach(body.shape, Matrix3d::Identity(), -part.normal);
  if (lowest <= part.normal.dot(part.point)) return;
  held.refuse("point",
              fmt::format("no part of the body lies below this plane: in its own frame, whose "
                          "origin is its centre, it spans {} to {} m",
                          text_of(most(body.shape, -1.0)), text_of(most(body.shape, 1.0))));
}

void read_held(TomlTable& table, ProblemBody& body) {
  if (!table.has("held")) return;
  TomlTable held = table.table("held", problem_keys::held());
  body.held = HeldPart{held.vector("point"), read_direction(held, "normal")};
  refuse_held_beside(held, body);
  held.finish();
  if (table.has("motion")) body.motion = read_motion(table.table("motion", problem_keys::motion()));
}

void read_material(TomlTable& table, ProblemBody& body) {
  body.mass = table.number("mass");
  if (!(body.mass > 0.0)) table.refuse("mass", "'mass' must be positive");
  Elasticity& elasticity = body.elasticity;
  elasticity.youngs_modulus = table.number("youngs_modulus", elasticity.youngs_modulus);
  if (!(elasticity.youngs_modulus > 0.0)) {
    table.refuse("youngs_modulus", "'youngs_modulus' must be positive");
  }
  elasticity.poisson_ratio = table.number("poisson_ratio", elasticity.poisson_ratio);
  if (!(elasticity.poisson_ratio > -1.0 && elasticity.poisson_ratio < 0.5)) {
    table.refuse("poisson_ratio", "'poisson_ratio' must lie between -1 and 0.5");
  }
  elasticity.damping_time = table.number("damping_time", elasticity.damping_time);
  if (!(elasticity.damping_time >= 0.0)) {
    table.refuse("damping_time", "'damping_time' must not be negative");
  }
}

}  // namespace

void read_body(TomlTable table, Reading& reading) {
  ProblemBody body;
  body.shape = read_shape(table);
  read_held(table, body);
  read_material(table, body);
  body.self_collision = table.flag("self_collision", false);
  body.angular_velocity = table.vector("spin", Vector3d::Zero());
  if (table.has("spin") && std::holds_alternative<PointShape>(body.shape)) {
    table.refuse("spin", "a point does not turn");
  }
  read_pose(table, reading, body);
  body.name = reading.bodies.add(table);  // now: it cannot rest on itself
  reading.user.problem.bodies.push_back(body);
  table.finish();
}

}  // namespace stiction
