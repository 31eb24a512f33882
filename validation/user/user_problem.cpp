// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/user_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reports/text/names.h"
#include "reports/text/text.h"
#include "solver/demand.h"
#include "validation/user/surface_shape.h"
#include "validation/user/toml_reader.h"

namespace stiction {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

template <class Named>
std::size_t find_named(const std::vector<Named>& all, TomlTable& table, const std::string& key) {
  const std::string name = table.text(key);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].name == name) return k;
  }
  table.refuse(key, fmt::format("there is no {} '{}'; there are: {}", key, name,
                                listed_names(all, [](const Named& one) { return one.name; })));
}

template <class Named>
std::string new_name(const std::vector<Named>& all, TomlTable& table) {
  const std::string name = table.text("name");
  if (name != one_line(name)) table.refuse("name", "a name must be one line of plain text");
  if (std::any_of(all.begin(), all.end(), [&](const Named& one) { return one.name == name; })) {
    table.refuse("name", "the name '" + name + "' is taken");
  }
  return name;
}

Vec3 unit_vector(TomlTable& table, const std::string& key) {
  const Vec3 vector = table.vector(key);
  if (!(vector.norm() > 0.0)) table.refuse(key, fmt::format("'{}' must not be zero", key));
  return vector.normalized();
}

void read_obstacle(TomlTable table, UserProblem& user) {
  Obstacle obstacle;
  obstacle.name = new_name(user.problem.obstacles, table);
  obstacle.point = table.vector("point", Vec3::Zero());
  obstacle.friction = table.number("friction");
  if (table.has("normal")) {
    obstacle.normal = unit_vector(table, "normal");
    if (table.has("slope_deg")) table.refuse("slope_deg", "give 'normal' or 'slope_deg', not both");
  } else {
    const double slope = table.number("slope_deg", 0.0) * kDegree;
    const double azimuth = table.number("azimuth_deg", 0.0) * kDegree;
    obstacle.normal = Vec3(std::sin(slope) * std::cos(azimuth), std::sin(slope) * std::sin(azimuth),
                           std::cos(slope))
                          .normalized();
  }
  const double azimuth = table.number("azimuth_deg", 0.0) * kDegree;
  // Steepest descent; along the azimuth on level ground.
  const Vec3& n = obstacle.normal;
  const Vec3 descent = -Vec3::UnitZ() + n.z() * n;
  const Vec3 level(std::cos(azimuth), std::sin(azimuth), 0.0);
  user.downhill.push_back(descent.norm() > 1e-9 ? descent.normalized()
                                                : Vec3((level - n.dot(level) * n).normalized()));
  user.problem.obstacles.push_back(obstacle);
  table.finish();
}

// How far above a plane the centre of a body (a mesh's origin) lies that rests on it.
double height_of_centre(const Shape& shape) {
  if (const auto* const box = std::get_if<BoxShape>(&shape)) return 0.5 * box->size.z();
  if (const auto* const ball = std::get_if<BallShape>(&shape)) return ball->radius;
  if (const auto* const mesh = std::get_if<MeshShape>(&shape)) {
    return -mesh->mesh.vertices.row(2).minCoeff();
  }
  return 0.0;
}

void read_pose(TomlTable& table, const UserProblem& user, ProblemBody& body) {
  if (!table.has("rests_on")) {
    body.position = table.vector("position");
    if (table.is_table("rotation")) {
      TomlTable rotation = table.table("rotation");
      const Vec3 axis = unit_vector(rotation, "axis");
      body.rotation = Eigen::AngleAxisd(rotation.number("angle_deg") * kDegree, axis);
      rotation.finish();
    } else if (table.has("rotation")) {
      table.refuse("rotation", "'rotation' must be like { axis = [0, 0, 1], angle_deg = 30 }");
    }
    body.velocity = table.vector("velocity", Vec3::Zero());
    return;
  }
  const std::size_t support = find_named(user.problem.obstacles, table, "rests_on");
  const Obstacle& obstacle = user.problem.obstacles[support];
  const Vec3& downhill = user.downhill[support];
  const double height = height_of_centre(body.shape);
  Eigen::Matrix3d axes;
  axes << downhill, obstacle.normal.cross(downhill), obstacle.normal;
  body.rotation = Eigen::Quaterniond(axes) *
                  Eigen::AngleAxisd(table.number("yaw_deg", 0.0) * kDegree, Vec3::UnitZ());
  body.position = obstacle.point + height * obstacle.normal;
  body.velocity = table.number("speed_downhill", 0.0) * downhill;
}

MeshShape read_mesh(TomlTable& table) {
  const std::vector<Vec3> vertices = table.vectors("vertices");
  MeshShape shape;
  shape.mesh.vertices.resize(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    shape.mesh.vertices.col(static_cast<Eigen::Index>(v)) = vertices[v];
  }
  shape.mesh.tetrahedra = table.tetrahedra("tetrahedra");
  if (shape.mesh.tetrahedra.cols() == 0) {
    table.refuse("tetrahedra", "a mesh needs at least one tetrahedron");
  }
  return shape;
}

void read_body(TomlTable table, UserProblem& user) {
  ProblemBody body;
  body.name = new_name(user.problem.bodies, table);
  const std::string shape = table.text("shape");
  if (shape == "box") {
    const Vec3 size = table.vector("size");
    if (!(size.array() > 0.0).all()) table.refuse("size", "a box needs three positive edges");
    body.shape = BoxShape{size};
  } else if (shape == "ball") {
    const double radius = table.number("radius");
    if (!(radius > 0.0)) table.refuse("radius", "'radius' must be positive");
    body.shape = BallShape{radius};
  } else if (shape == "mesh") {
    body.shape = read_mesh(table);
  } else if (shape == "surface") {
    body.shape = read_surface(table);
  } else if (shape == "point") {
    body.shape = PointShape{};
  } else {
    table.refuse("shape",
                 "there is no shape '" + shape + "'; there are: box, ball, mesh, surface, point");
  }
  if (table.has("held")) {
    TomlTable held = table.table("held");
    body.held = HeldPart{held.vector("point"), unit_vector(held, "normal")};
    held.finish();
  }
  body.mass = table.number("mass");
  body.elasticity.youngs_modulus = table.number("youngs_modulus", body.elasticity.youngs_modulus);
  body.elasticity.poisson_ratio = table.number("poisson_ratio", body.elasticity.poisson_ratio);
  body.elasticity.damping_time = table.number("damping_time", body.elasticity.damping_time);
  read_pose(table, user, body);
  user.problem.bodies.push_back(body);
  table.finish();
}

Gravity read_gravity(TomlTable& top) {
  if (!top.is_table("gravity")) {
    return {{0.0}, {top.vector("gravity", Vec3(0.0, 0.0, -9.81))}};
  }
  TomlTable table = top.table("gravity");
  Gravity gravity{table.numbers("time"), table.vectors("acceleration")};
  if (gravity.time.size() != gravity.acceleration.size() || gravity.time.empty()) {
    table.refuse("time", "gravity needs as many times as accelerations, at least one");
  }
  table.finish();
  return gravity;
}

Drag read_drag(TomlTable table) {
  const Drag drag{table.number("rate"), table.number("full_until"), table.number("ends")};
  if (!(drag.rate >= 0.0)) table.refuse("rate", "'rate' must not be negative");
  if (!(drag.full_until < drag.ends)) table.refuse("ends", "'ends' must follow 'full_until'");
  table.finish();
  return drag;
}

void read_check(TomlTable table, UserProblem& user) {
  UserCheck one;
  const std::string name = table.text("observable");
  one.observable = nullptr;
  for (const Observable& observable : observables()) {
    if (observable.name == name) one.observable = &observable;
  }
  if (!one.observable) {
    table.refuse("observable",
                 fmt::format("there is no observable '{}'; there are: {}", name,
                             listed_names(observables(), [](const Observable& observable) {
                               return observable.name;
                             })));
  }
  one.body = table.has("body") ? find_named(user.problem.bodies, table, "body") : 0;
  one.at = table.number("at", user.problem.duration);
  if (one.observable->over_window) one.from = table.number("from", 0.0);
  if (!(one.from >= 0.0 && one.from < one.at && one.at <= user.problem.duration)) {
    table.refuse("at", fmt::format("the times of a check must follow 0 ≤ from < at ≤ {} s",
                                   user.problem.duration));
  }
  if (one.observable->in_direction) {
    if (table.is_text("direction")) {
      const std::string word = table.text("direction");
      if (word != "downhill" || user.downhill.empty()) {
        table.refuse("direction",
                     "'direction' is three numbers or, with an obstacle, \"downhill\"");
      }
      one.direction = user.downhill.front();
    } else {
      one.direction = unit_vector(table, "direction");
    }
  }
  one.claim.quantity = table.text("quantity", name);
  one.claim.unit = one.observable->unit;
  one.claim.statement = table.text("claim", one.observable->meaning);
  one.claim.source = table.text("source", "the problem's author");
  one.claim.kind = ReferenceKind::kExternal;
  one.claim.expected = table.number("expected");
  one.claim.relative = table.flag("relative", false);
  if (table.has("scale")) one.claim.scale = table.number("scale");
  one.claim.tolerance = table.number("tolerance");
  one.claim.reason = table.text("reason");
  if (!(one.claim.tolerance >= 0.0)) table.refuse("tolerance", "'tolerance' must not be negative");
  if (one.claim.scale && !(*one.claim.scale > 0.0 && std::isfinite(*one.claim.scale))) {
    table.refuse("scale", "'scale' must be positive: what digits count from");
  }
  if (one.claim.relative && !scale_of(one.claim)) {
    table.refuse("relative",
                 "an error relative to an expected value of 0 has no meaning without a 'scale'");
  }
  user.checks.push_back(one);
  table.finish();
}

UserProblem read(const std::string& file, const toml::table& root) {
  TomlTable top(file, root, "the file");
  UserProblem user;
  user.title = top.text("title", "");
  user.problem.name = one_line(user.title);
  user.problem.duration = top.number("duration");
  if (!(user.problem.duration > 0.0)) top.refuse("duration", "'duration' must be positive");
  user.problem.gravity = read_gravity(top);
  if (top.has("drag")) user.problem.drag = read_drag(top.table("drag"));
  user.problem.friction = top.number("friction", 0.0);
  if (top.has("engine")) {
    for (auto& [key, value] : top.table("engine").all_as_text()) user.settings[key] = value;
  }
  for (TomlTable& table : top.tables("obstacle")) read_obstacle(table, user);
  for (TomlTable& table : top.tables("body")) read_body(table, user);
  for (TomlTable& table : top.tables("check")) read_check(table, user);
  if (user.problem.bodies.empty()) top.refuse("body", "the file describes no [[body]]");
  if (user.checks.empty()) top.refuse("check", "the file has no [[check]], so nothing could fail");
  top.finish();
  return user;
}

}  // namespace

UserProblem user_problem(std::istream& text, const std::filesystem::path& file) {
  toml::table root;
  try {
    root = toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: {}", file.string(), error.source().begin.line,
                                 one_line(error.description())));
  }
  return read(file.string(), root);
}

}  // namespace stiction
