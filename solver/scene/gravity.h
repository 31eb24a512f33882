// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solver/real.h"

namespace stiction {

/// 6s⁵ − 15s⁴ + 10s³: from 0 to 1 with two continuous derivatives, for s in [0, 1].
inline double smooth_step(double s) { return s * s * s * (10.0 + s * (6.0 * s - 15.0)); }

/// Value at time t of keyframes joined by the C² smooth step 6s⁵ − 15s⁴ + 10s³, constant outside
/// them; zero when there are none.
Eigen::Vector3d smooth_keyframes(const std::vector<double>& time,
                                 const std::vector<Eigen::Vector3d>& value, double t);

/// Planned displacement from the initial place over time; none is at rest.
struct Motion {
  std::vector<double> time{};                          ///< s, increasing
  std::vector<Eigen::Vector3d> offset{};               ///< m, one a keyframe
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s: steadily, on top of them
  bool moves() const { return !time.empty() || !velocity.isZero(0.0); }
  Eigen::Vector3d at(double t) const { return smooth_keyframes(time, offset, t) + t * velocity; }
  /// From t on, over `dt` (s), m/s: a difference of places, but for the steady part.
  Eigen::Vector3d mean_velocity(double t, double dt) const {
    return (smooth_keyframes(time, offset, t + dt) - smooth_keyframes(time, offset, t)) / dt +
           velocity;
  }
};

/// Gravity over time: keyframes joined by the C² smooth step 6s⁵ − 15s⁴ + 10s³, constant outside
/// them. One keyframe is constant gravity; none is weightlessness.
struct Gravity {
  std::vector<double> time;                   ///< s, increasing
  std::vector<Eigen::Vector3d> acceleration;  ///< m/s², one a keyframe
  Eigen::Vector3d at(double t) const { return smooth_keyframes(time, acceleration, t); }
  /// The strongest of its keyframes, m/s²; 0 without any, for a weightless scene has no scale of its
  /// own.
  double scale() const;
};

/// A viscous medium in which a scene may settle, and which then vanishes: force −m c v on each
/// vertex. Without it a heavy body on a soft one bounces for seconds, because damping by strain
/// rate hardly acts on so slow a motion.
struct Drag {
  double rate = 0.0;        ///< c, 1/s, ≥ 0
  double full_until = 0.0;  ///< s
  double ends = 0.0;        ///< s, > full_until: it has faded out by the smooth step
  double at(double t) const;
};

}  // namespace stiction
