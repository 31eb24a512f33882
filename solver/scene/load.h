// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "solver/scene/gravity.h"

namespace stiction {

/// A vector over time: keyframes joined by the C² smooth step, constant outside them; without any
/// it is zero.
struct VectorOverTime {
  std::vector<double> time{};  ///< s, increasing
  std::vector<Vec3> value{};   ///< one a keyframe
  Vec3 at(double t) const { return smooth_keyframes(time, value, t); }
};

/// A force on a body, spread over it like its mass, and a couple, spread as if the body were rigid.
struct Load {
  std::size_t body = 0;
  VectorOverTime force{};   ///< N
  VectorOverTime couple{};  ///< N m
};

/// A spring from a body's centre of mass to an anchor that moves steadily, along one axis:
/// force = stiffness · axis · (axis · (anchor + t · anchor_velocity − centre)), spread like the mass.
struct Spring {
  std::size_t body = 0;
  Vec3 anchor = Vec3::Zero();           ///< at t = 0, m
  Vec3 anchor_velocity = Vec3::Zero();  ///< m/s
  Vec3 axis = Vec3::UnitX();            ///< unit length
  double stiffness = 0.0;               ///< N/m, ≥ 0
};

}  // namespace stiction
