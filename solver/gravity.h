// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace stiction {

using Vec3 = Eigen::Vector3d;

/// Gravity over time: keyframes joined by the C² smooth step 6s⁵ − 15s⁴ + 10s³, constant outside
/// them. One keyframe is constant gravity; none is weightlessness.
struct Gravity {
  std::vector<double> time;        ///< s, increasing
  std::vector<Vec3> acceleration;  ///< m/s², one a keyframe
  Vec3 at(double t) const;
};

}  // namespace stiction
