// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/piles/ball_pyramid_problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "reference/meshes/ball_mesh.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

double mass_of(const BallPyramidSetup& setup, double radius) {
  return setup.density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

// A ball on a facet, turned by `yaw` about the vertical.
ProblemBody ball(const BallPyramidSetup& setup, const std::string& name, double radius,
                 double yaw) {
  ProblemBody body;
  body.name = name;
  body.shape = BallShape{radius};
  body.mass = mass_of(setup, radius);
  body.elasticity = setup.elasticity;
  body.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Vec3::UnitZ())) *
                  Eigen::Quaterniond(reference::facet_down(setup.frequency));
  return body;
}

// A triangulated ball lies inside its sphere, and stands where its lowest vertices are: how far it
// reaches along the unit vector `along`, m.
double reach(const ProblemBody& body, int frequency, const Vec3& along) {
  const TetMesh mesh = reference::ball_mesh(
      {.radius = std::get<BallShape>(body.shape).radius, .frequency = frequency});
  return (mesh.vertices.transpose() * (body.rotation.conjugate() * along)).maxCoeff();
}

Vec3 level(const Vec3& v) { return {v.x(), v.y(), 0.0}; }

}  // namespace

Problem ball_pyramid_problem(const BallPyramidSetup& setup) {
  const double r = setup.radius;
  const int n = setup.frequency;
  const double smooth = (1.0 + setup.ratio) * r;        // centre to centre
  const double spread = 2.0 * r / std::numbers::sqrt3;  // of three touching balls
  const double rise = std::sqrt(smooth * smooth - spread * spread);
  Problem problem;
  problem.name = "four balls";
  ProblemBody top = ball(setup, "top", setup.ratio * r, 0.0);
  double height = 0.0;
  for (std::size_t k = 0; k < kLowerBalls; ++k) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / 3.0;
    const Vec3 outward(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 up = (rise * Vec3::UnitZ() - spread * outward).normalized();
    ProblemBody lower = ball(setup, "lower " + std::to_string(k), r, angle);
    lower.position = spread * outward + reach(lower, n, -Vec3::UnitZ()) * Vec3::UnitZ();
    // A plane across the line of centres parts the two.
    const double apart = reach(lower, n, up) + reach(top, n, -up);
    height = std::max(height, lower.position.z() + std::sqrt(apart * apart - spread * spread));
    problem.bodies.push_back(lower);
  }
  top.position = Vec3(0.0, 0.0, height);
  problem.bodies.push_back(top);
  problem.obstacles = {{"ground", Vec3::Zero(), Vec3::UnitZ(), setup.friction}};
  problem.gravity = {{0.0, setup.full_load}, {Vec3::Zero(), Vec3(0.0, 0.0, -kStandardGravity)}};
  problem.drag = setup.drag;
  problem.friction = setup.friction;
  return problem;
}

PyramidShape pyramid_shape(const Engine& engine) {
  PyramidShape shape;
  const Vec3 top = engine.body(kTopBall).position;
  shape.top_height = shape.rise = top.z();
  for (std::size_t k = 0; k < kLowerBalls; ++k) {
    const BodyMotion motion = engine.body(k);
    const Vec3 arm = level(motion.position - top);
    shape.rise -= motion.position.z() / kLowerBalls;
    shape.spread += arm.norm() / kLowerBalls;
    shape.speed += arm.normalized().dot(motion.velocity) / kLowerBalls;
  }
  return shape;
}

reference::LimitProblem limit_problem(const Engine& engine, const BallPyramidSetup& setup,
                                      const std::vector<ContactSample>& contacts,
                                      ContactLoads loads) {
  reference::LimitProblem problem;
  for (std::size_t b = 0; b <= kTopBall; ++b) {
    problem.bodies.push_back(
        {mass_of(setup, b == kTopBall ? setup.ratio * setup.radius : setup.radius),
         engine.body(b).position});
  }
  problem.gravity = Vec3(0.0, 0.0, -kStandardGravity);
  for (const ContactSample& sample : contacts) {
    if (!(sample.normal_force > 0.0)) continue;
    if (loads == ContactLoads::kMeasured) {
      problem.clamps.push_back({{static_cast<int>(problem.contacts.size())}, sample.normal_force});
    }
    problem.contacts.push_back(
        {static_cast<int>(sample.body),
         sample.against_body ? static_cast<int>(sample.obstacle) : reference::kFixed,
         sample.position, sample.normal.normalized()});
  }
  return problem;
}

reference::SoftFourBallThreshold smooth_threshold(const BallPyramidSetup& setup) {
  return reference::soft_four_ball_threshold({.radius = setup.radius,
                                              .ratio = setup.ratio,
                                              .density = setup.density,
                                              .youngs_modulus = setup.elasticity.youngs_modulus,
                                              .poisson_ratio = setup.elasticity.poisson_ratio,
                                              .gravity = kStandardGravity});
}

}  // namespace stiction
