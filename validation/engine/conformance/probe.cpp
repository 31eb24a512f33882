// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/conformance/probe.h"

#include <cmath>

#include "reference/meshes/box_mesh.h"

namespace stiction {

namespace {

struct HalfHeight {
  double operator()(const BoxShape& box) const { return 0.5 * box.size.z(); }
  double operator()(const BallShape& ball) const { return ball.radius; }
  double operator()(const PointShape&) const { return 0.0; }
  double operator()(const MeshShape& shape) const { return -shape.mesh.vertices.row(2).minCoeff(); }
};

}  // namespace

double half_height(const ProblemBody& body) { return std::visit(HalfHeight{}, body.shape); }

ProblemBody Probe::body(const std::string& name) const {
  const Vec3 size(0.2, 0.16, 0.1);
  ProblemBody body;
  body.name = name;
  body.mass = 2.0;
  body.elasticity = {.youngs_modulus = 5e5, .poisson_ratio = 0.3, .damping_time = 1e-3};
  if (manifest().boxes) {
    body.shape = BoxShape{size};
  } else if (manifest().balls) {
    body.shape = BallShape{0.1};
  } else if (manifest().point_masses) {
    body.shape = PointShape{};
  } else {
    body.shape = MeshShape{reference::box_mesh(size, Eigen::Vector3i::Ones()), true};
  }
  return body;
}

std::unique_ptr<Engine> Probe::start(const Problem& problem, const Accuracy& accuracy) const {
  const std::string lacking = missing(manifest(), problem);
  if (!lacking.empty()) throw NotApplicable("the engine has no " + lacking);
  auto engine = kind_.make(settings_);
  engine->load(problem, accuracy);
  return engine;
}

void Probe::need(bool has, const std::string& words) const {
  if (!has) throw NotApplicable("the engine has no " + words);
}

double advance_to(Engine& engine, double time) {
  const auto target = static_cast<std::uint64_t>(std::ceil(time / engine.time_step() - 1e-9));
  if (target > engine.steps_done()) engine.advance(target - engine.steps_done());
  return static_cast<double>(engine.steps_done()) * engine.time_step();
}

}  // namespace stiction
