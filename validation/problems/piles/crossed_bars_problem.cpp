// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/piles/crossed_bars_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/meshes/box_mesh.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

double in_radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

ProblemBody bar(const CrossedBarsSetup& setup, const std::string& name) {
  ProblemBody body;
  body.name = name;
  body.shape = MeshShape{reference::box_mesh(setup.size, {setup.cells, 1, 1})};
  body.mass = setup.density * setup.size.prod();
  body.elasticity = setup.elasticity;
  return body;
}

// Wider than the bar, so that the bar's end vertices stand on it as in every other scene.
ProblemBody support(const CrossedBarsSetup& setup, double x) {
  const Vec3 size(0.06, 0.09, 0.05);
  ProblemBody body;
  body.name = x < 0.0 ? "left support" : "right support";
  body.shape = MeshShape{reference::box_mesh(size, {2, 3, 1})};
  body.mass = setup.density * size.prod();
  body.elasticity = setup.elasticity;
  body.position = Vec3(x, 0.0, -setup.size.z() - 0.5 * size.z());
  body.held = HeldPart{Vec3(0.0, 0.0, -0.5 * size.z()), Vec3::UnitZ()};
  return body;
}

// Of the upper bar's centre, and from its frame to the lower bar's.
struct Pose {
  Eigen::Rotation2Dd turn;
  Eigen::Vector2d centre;
};
Pose pose_of(const CrossedBarsSetup& setup) {
  const Eigen::Rotation2Dd turn(in_radians(setup.angle));
  const Eigen::Vector2d across = turn * Eigen::Vector2d(setup.along_upper, 0.0);
  return {turn, Eigen::Vector2d(setup.along_lower, 0.0) - across};
}

// Of a point from the outline of a bar about the origin along x; negative inside.
double outside(const CrossedBarsSetup& setup, const Eigen::Vector2d& point) {
  return std::max(std::abs(point.x()) - 0.5 * setup.size.x(),
                  std::abs(point.y()) - 0.5 * setup.size.y());
}

}  // namespace

Problem crossed_bars_problem(const CrossedBarsSetup& setup) {
  const Pose pose = pose_of(setup);
  ProblemBody upper = bar(setup, "upper bar");
  upper.position = Vec3(pose.centre.x(), pose.centre.y(), 0.5 * setup.size.z());
  upper.rotation = Eigen::AngleAxisd(in_radians(setup.angle), Vec3::UnitZ());
  ProblemBody lower = bar(setup, "lower bar");
  lower.position = Vec3(0.0, 0.0, -0.5 * setup.size.z());
  Problem problem;
  problem.name = "crossed bars";
  problem.bodies = {upper, lower};
  if (setup.on_supports) {
    for (const double x : {-0.17, 0.17}) problem.bodies.push_back(support(setup, x));
  } else {
    problem.bodies[1].held = HeldPart{Vec3(0.0, 0.0, -0.5 * setup.size.z()), Vec3::UnitZ()};
  }
  problem.friction = setup.friction;
  problem.gravity = {{0.0, 0.4}, {Vec3::Zero(), Vec3(0.0, 0.0, -kStandardGravity)}};
  problem.drag = setup.drag;
  return problem;
}

double clearance(const CrossedBarsSetup& setup) {
  const Pose pose = pose_of(setup);
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= setup.cells; ++k) {
    const double along = setup.size.x() * (static_cast<double>(k) / setup.cells - 0.5);
    for (const double side : {-0.5, 0.5}) {
      const Eigen::Vector2d vertex(along, side * setup.size.y());
      least = std::min({least, outside(setup, pose.turn * vertex + pose.centre),
                        outside(setup, pose.turn.inverse() * (vertex - pose.centre))});
    }
  }
  return least;
}

std::vector<CrossedBarsSetup> crossed_bars() {
  std::vector<CrossedBarsSetup> setups;
  for (const bool on_supports : {false, true}) {
    for (const double angle : {90.0, 75.0, 60.0, 50.0}) {
      for (const double offset : {0.0, 4e-3}) {
        CrossedBarsSetup setup;
        setup.angle = angle;
        setup.along_lower = offset;
        setup.along_upper = 0.75 * offset;
        setup.on_supports = on_supports;
        setups.push_back(setup);
      }
    }
  }
  return setups;
}

std::string crossed_bars_words(const CrossedBarsSetup& setup) {
  return fmt::format("at {:.0f}°, {:.0f} and {:.0f} mm off the middles, {}", setup.angle,
                     1e3 * setup.along_lower, 1e3 * setup.along_upper,
                     setup.on_supports ? "on supports" : "lower face held");
}

}  // namespace stiction
