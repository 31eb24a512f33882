// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/slopes/incline_problem.h"

#include <cmath>

namespace stiction {

namespace {

double height_of_centre(const Shape& shape) {
  const auto* const box = std::get_if<BoxShape>(&shape);
  return box ? 0.5 * box->size.z() : 0.0;
}

}  // namespace

InclineFrame incline_frame(const InclineSetup& setup) {
  const double cosine = 1.0 / std::hypot(1.0, setup.tan_slope);
  const double sine = setup.tan_slope * cosine;
  const Vec3 level(std::cos(setup.azimuth), std::sin(setup.azimuth), 0.0);
  // Normalised again so that round-off of cos² + sin² does not scale depths.
  return {(sine * level + cosine * Vec3::UnitZ()).normalized(),
          (cosine * level - sine * Vec3::UnitZ()).normalized()};
}

Problem incline_problem(const InclineSetup& setup) {
  const InclineFrame frame = incline_frame(setup);
  ProblemBody body;
  body.name = "box";
  body.shape = setup.shape;
  body.mass = setup.mass;
  body.elasticity = setup.elasticity;
  body.must_deform = setup.must_deform;
  body.position = height_of_centre(setup.shape) * frame.normal;
  Eigen::Matrix3d axes;
  axes << frame.downhill, frame.normal.cross(frame.downhill), frame.normal;
  body.rotation =
      Eigen::Quaterniond(axes) * Eigen::Quaterniond(Eigen::AngleAxisd(setup.yaw, Vec3::UnitZ()));
  body.velocity = setup.speed * frame.downhill;

  Problem problem;
  problem.name = "incline";
  problem.bodies = {body};
  problem.obstacles = {{"plane", Vec3::Zero(), frame.normal, setup.friction}};
  problem.gravity = {{0.0}, {Vec3(0.0, 0.0, -kStandardGravity)}};
  problem.duration = setup.duration;
  return problem;
}

Problem settled_incline_problem(const InclineSetup& setup, const SettledLoad& load) {
  Problem problem = incline_problem(setup);
  const Vec3 normal = incline_frame(setup).normal;
  const Vec3 full = problem.gravity.acceleration.front();
  const Vec3 into_plane = normal.dot(full) * normal;
  problem.gravity = {{0.0, load.normal_full, load.tangential_from, load.tangential_full},
                     {Vec3::Zero(), into_plane, into_plane, full}};
  return problem;
}

}  // namespace stiction
