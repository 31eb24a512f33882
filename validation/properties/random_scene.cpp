// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/properties/random_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>

namespace stiction::test {

namespace {

int zigzag(int k) { return k % 2 == 0 ? -k / 2 : (k + 1) / 2; }

const Vec3 kAxes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {3, -2, 1}};

// A tetrahedron with its centre of mass at the origin, none of whose sides is like another.
MeshShape tetrahedron(double size) {
  MeshShape shape;
  shape.mesh.vertices.resize(3, 4);
  shape.mesh.vertices << 0, 1, 0.1, 0.3, 0, 0.1, 1, 0.2, 0, 0, 0.1, 0.9;
  shape.mesh.vertices *= size;
  const Vec3 centre = shape.mesh.vertices.rowwise().mean();
  shape.mesh.vertices.colwise() -= centre;
  shape.mesh.tetrahedra = Eigen::Vector4i(0, 1, 2, 3);
  shape.convex = true;
  return shape;
}

Shape shape_of(const RandomBody& body, double size) {
  switch (body.shape) {
    case 0:
      return BoxShape{Vec3(size, 1.2 * size, 0.8 * size)};
    case 1:
      return BallShape{0.5 * size};
    case 2:
      return tetrahedron(size);
    default:
      return PointShape{};
  }
}

// How far it reaches from its centre of mass along a direction, m.
double reach(const ProblemBody& body, const Vec3& direction) {
  const Vec3 d = body.rotation.inverse() * direction;
  if (const auto* const box = std::get_if<BoxShape>(&body.shape)) {
    return 0.5 * box->size.dot(d.cwiseAbs());
  }
  if (const auto* const ball = std::get_if<BallShape>(&body.shape)) return ball->radius;
  if (const auto* const mesh = std::get_if<MeshShape>(&body.shape)) {
    return (d.transpose() * mesh->mesh.vertices).maxCoeff();
  }
  return 0.0;
}

constexpr double kSlab = 0.1;  // thickness, m

ProblemBody slab(double stiffness) {
  ProblemBody body;
  body.name = "slab";
  body.shape = BoxShape{Vec3(0.6, 0.6, kSlab)};
  body.mass = 30.0;
  body.elasticity.youngs_modulus = stiffness;
  body.position = Vec3(0, 0, -0.5 * kSlab);
  body.held = HeldPart{Vec3(0, 0, -0.5 * kSlab), Vec3::UnitZ()};
  return body;
}

}  // namespace

double friction_of(const RandomScene& scene) {
  return scene.mu * std::pow(10.0, zigzag(scene.mu_decade));
}

Problem problem_of(const RandomScene& scene) {
  Problem problem;
  problem.name = "random";
  problem.friction = friction_of(scene);
  const double slope = scene.slope * std::numbers::pi / 180.0;
  const Vec3 up = scene.ground == 1 ? Vec3(std::sin(slope), 0.0, std::cos(slope)) : Vec3::UnitZ();
  double heaviest = 1.0;
  for (const RandomBody& one : scene.bodies) {
    heaviest = std::max(heaviest, std::pow(10.0, zigzag(one.mass)));
  }
  // In proportion to what may lie on a body, or strike it.
  const double stiffness = 5e5 * heaviest;
  if (scene.ground == 1) {
    Obstacle plane;
    plane.name = "plane";
    plane.normal = up.normalized();
    plane.friction = problem.friction;
    problem.obstacles.push_back(plane);
  }
  if (scene.ground == 2) problem.bodies.push_back(slab(stiffness));
  Vec3 top = Vec3::Zero();
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const RandomBody& one = scene.bodies[k];
    const double size = 0.1 * std::pow(2.0, zigzag(one.size));
    ProblemBody body;
    body.name = fmt::format("body {}", k + 1);
    body.shape = shape_of(one, size);
    body.mass = std::pow(10.0, zigzag(one.mass));
    body.elasticity.youngs_modulus = stiffness;
    body.elasticity.damping_time = 1e-4 * scene.damping;
    const Vec3 axis = kAxes[one.axis].normalized();
    body.rotation = Eigen::AngleAxisd(zigzag(one.angle) * std::numbers::pi / 18.0, axis);
    const Vec3 aside(0.01 * zigzag(one.aside[0]), 0.01 * zigzag(one.aside[1]), 0.0);
    const Vec3 across = aside - up.dot(aside) * up;
    // 1 µm, as a triangulated ball doesn't reach out everywhere, but round-off does.
    body.position = top + across + (1e-5 * one.gap + 1e-6 + reach(body, -up)) * up;
    top += up.dot(body.position - top) * up + reach(body, up) * up;
    // Downwards, and faster than what is below: they meet.
    body.velocity = Vec3(0.1 * zigzag(one.velocity[0]), 0.1 * zigzag(one.velocity[1]),
                         -0.1 * one.velocity[2] * static_cast<double>(k + 1));
    if (one.shape != 3) body.angular_velocity = zigzag(one.spin) * axis;
    problem.bodies.push_back(body);
  }
  if (scene.gravity != 0) problem.gravity = {{0.0}, {Vec3(0, 0, -9.81)}};
  if (scene.drag > 0) {
    problem.drag = {static_cast<double>(scene.drag), 1e3, 2e3};
  }
  const Vec3 load(zigzag(scene.load[0]), zigzag(scene.load[1]), zigzag(scene.load[2]));
  if (!load.isZero(0.0) && !scene.bodies.empty()) {
    const std::size_t body = scene.ground == 2 ? 1 : 0;
    problem.loads.push_back({body, {{0.0}, {0.25 * 9.81 * problem.bodies[body].mass * load}}, {}});
  }
  return problem;
}

void show(std::ostream& stream, const RandomScene& scene) {
  stream << fmt::format(
      "{{.ground = {}, .slope = {}, .gravity = {}, .mu_decade = {}, .mu = {}, .damping = {}, "
      ".drag = {}, .load = {{{}, {}, {}}}, .bodies = {{",
      scene.ground, scene.slope, scene.gravity, scene.mu_decade, scene.mu, scene.damping,
      scene.drag, scene.load[0], scene.load[1], scene.load[2]);
  for (const RandomBody& one : scene.bodies) {
    stream << fmt::format(
        "{{.shape = {}, .size = {}, .mass = {}, .aside = {{{}, {}}}, .gap = {}, .axis = {}, "
        ".angle = {}, .velocity = {{{}, {}, {}}}, .spin = {}}},",
        one.shape, one.size, one.mass, one.aside[0], one.aside[1], one.gap, one.axis, one.angle,
        one.velocity[0], one.velocity[1], one.velocity[2], one.spin);
  }
  stream << "}}";
}

}  // namespace stiction::test
