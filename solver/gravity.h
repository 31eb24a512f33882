// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace stiction {

using Vec3 = Eigen::Vector3d;

/// Value at time t of keyframes joined by the C² smooth step 6s⁵ − 15s⁴ + 10s³, constant outside
/// them; zero when there are none.
Vec3 smooth_keyframes(const std::vector<double>& time, const std::vector<Vec3>& value, double t);

/// Planned displacement from the initial place over time; none is at rest.
struct Motion {
  std::vector<double> time{};  ///< s, increasing
  std::vector<Vec3> offset{};  ///< m, one a keyframe
  Vec3 at(double t) const { return smooth_keyframes(time, offset, t); }
};

/// Gravity over time: keyframes joined by the C² smooth step 6s⁵ − 15s⁴ + 10s³, constant outside
/// them. One keyframe is constant gravity; none is weightlessness.
struct Gravity {
  std::vector<double> time;        ///< s, increasing
  std::vector<Vec3> acceleration;  ///< m/s², one a keyframe
  Vec3 at(double t) const { return smooth_keyframes(time, acceleration, t); }
};

}  // namespace stiction
