// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "solver/scene/gravity.h"

namespace stiction {

/// A vector over time: keyframes joined by the C² smooth step, constant outside them, and an
/// oscillation on top; without either it is zero.
struct VectorOverTime {
  std::vector<double> time{};            ///< s, increasing
  std::vector<Eigen::Vector3d> value{};  ///< one a keyframe
  Oscillation oscillation{};
  Eigen::Vector3d at(double t) const { return over_time(time, value, oscillation, t); }
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
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();           ///< at t = 0, m
  Eigen::Vector3d anchor_velocity = Eigen::Vector3d::Zero();  ///< m/s
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();            ///< unit length
  double stiffness = 0.0;                                     ///< N/m, ≥ 0
};

}  // namespace stiction
