// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/limit/limit_scenes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace stiction::reference {

namespace {

using Eigen::Vector3d;

}  // namespace

LimitProblem box_on_incline(const Vector3d& size, double mass) {
  LimitProblem problem;
  problem.bodies = {{mass, Vector3d(0.0, 0.0, 0.5 * size.z())}};
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      ContactPoint& contact = problem.contacts.emplace_back();
      contact.point = Vector3d(x * size.x(), y * size.y(), 0.0);
    }
  }
  problem.live_gravity = Vector3d(9.81, 0.0, 0.0);
  return problem;
}

LimitProblem box_stack(int boxes, const Vector3d& size) {
  LimitProblem problem;
  for (int k = 0; k < boxes; ++k) {
    problem.bodies.push_back({1.0, Vector3d(0.0, 0.0, (k + 0.5) * size.z())});
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        problem.contacts.push_back({k, k == 0 ? kFixed : k - 1,
                                    Vector3d(x * size.x(), y * size.y(), k * size.z()),
                                    Vector3d::UnitZ(), 1.0});
      }
    }
  }
  problem.live_gravity = Vector3d(9.81, 0.0, 0.0);
  return problem;
}

LimitProblem box_pyramid(int rows, double gap, bool touching) {
  LimitProblem problem;
  problem.live_gravity = Vector3d(9.81, 0.0, 0.0);
  const double pitch = 1.0 + gap;
  // The corners of a unit-deep patch: across x (top of a box) or across z (side of a box).
  const auto touch = [&](int a, int b, const Vector3d& low, const Vector3d& high,
                         const Vector3d& normal) {
    for (const double y : {-0.5, 0.5}) {
      for (const Vector3d& end : {low, high}) {
        problem.contacts.push_back({a, b, Vector3d(end.x(), y, end.z()), normal, 1.0});
      }
    }
  };
  int first_below = 0;
  for (int row = 0; row < rows; ++row) {
    const auto first = static_cast<int>(problem.bodies.size());
    const double z = row;
    for (int k = 0; k < rows - row; ++k) {
      const double x = pitch * (k + 0.5 * row);
      problem.bodies.push_back({1.0, Vector3d(x, 0.0, z + 0.5)});
      const Vector3d left(x - 0.5, 0.0, z);
      const Vector3d right(x + 0.5, 0.0, z);
      if (row == 0) {
        touch(first + k, kFixed, left, right, Vector3d::UnitZ());
      } else {
        const double inner_left = x - 0.5 * pitch + 0.5;
        const double inner_right = x + 0.5 * pitch - 0.5;
        touch(first + k, first_below + k, left, Vector3d(inner_left, 0.0, z), Vector3d::UnitZ());
        touch(first + k, first_below + k + 1, Vector3d(inner_right, 0.0, z), right,
              Vector3d::UnitZ());
      }
      if (touching && gap == 0.0 && k > 0) {
        touch(first + k, first + k - 1, left, left + Vector3d::UnitZ(), Vector3d::UnitX());
      }
    }
    first_below = first;
  }
  return problem;
}

LimitProblem four_ball_pyramid(double ratio, double ground_scale) {
  LimitProblem problem;
  const double ring = 2.0 / std::sqrt(3.0);
  const double rise = std::sqrt((1.0 + ratio) * (1.0 + ratio) - ring * ring);
  const Vector3d top(0.0, 0.0, 1.0 + rise);
  problem.bodies.push_back({ratio * ratio * ratio, top});
  for (int k = 0; k < 3; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 3.0;
    const Vector3d center(ring * std::cos(angle), ring * std::sin(angle), 1.0);
    problem.bodies.push_back({1.0, center});
    const Vector3d normal = (top - center).normalized();
    problem.contacts.push_back({0, k + 1, center + normal, normal, 1.0});
  }
  for (int k = 0; k < 3; ++k) {
    const Vector3d& center = problem.bodies[static_cast<std::size_t>(k + 1)].center_of_mass;
    problem.contacts.push_back(
        {k + 1, kFixed, center - Vector3d::UnitZ(), Vector3d::UnitZ(), ground_scale});
  }
  return problem;
}

FourBallThresholds four_ball_thresholds(double ratio) {
  const double half = 0.5 * std::asin(2.0 / std::sqrt(3.0) / (1.0 + ratio));
  const double friction = std::tan(half);
  return {friction, friction / (1.0 + 3.0 / (ratio * ratio * ratio))};
}

}  // namespace stiction::reference
