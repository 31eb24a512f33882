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

/// amplitude · e(t) · sin(2π · frequency · (t − begins) + phase), where e grows from 0 at `begins` to
/// 1 at `full_from` by the smooth step, or at once where they are equal; zero before.
struct Oscillation {
  Eigen::Vector3d amplitude = Eigen::Vector3d::Zero();  ///< in the unit of what oscillates
  double frequency = 0.0;                               ///< Hz, ≥ 0
  double phase = 0.0;                                   ///< rad
  double begins = 0.0;                                  ///< s
  double full_from = 0.0;                               ///< s, ≥ begins
  bool moves() const { return !amplitude.isZero(0.0); }
  Eigen::Vector3d at(double t) const;
};

/// Keyframes, and an oscillation on top of them where there is one.
inline Eigen::Vector3d over_time(const std::vector<double>& time,
                                 const std::vector<Eigen::Vector3d>& value,
                                 const Oscillation& oscillation, double t) {
  const Eigen::Vector3d steady = smooth_keyframes(time, value, t);
  return oscillation.moves() ? Eigen::Vector3d(steady + oscillation.at(t)) : steady;
}

/// Planned displacement from the initial place over time; none is at rest.
struct Motion {
  std::vector<double> time{};                          ///< s, increasing
  std::vector<Eigen::Vector3d> offset{};               ///< m, one a keyframe
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s: steadily, on top of them
  Oscillation oscillation{};                           ///< m, on top of both
  bool moves() const { return !time.empty() || !velocity.isZero(0.0) || oscillation.moves(); }
  Eigen::Vector3d at(double t) const {
    return over_time(time, offset, oscillation, t) + t * velocity;
  }
  /// From t on, over `dt` (s), m/s: a difference of places, but for the steady part.
  Eigen::Vector3d mean_velocity(double t, double dt) const {
    return (over_time(time, offset, oscillation, t + dt) -
            over_time(time, offset, oscillation, t)) /
               dt +
           velocity;
  }
};

/// Gravity over time: keyframes joined by the C² smooth step 6s⁵ − 15s⁴ + 10s³, constant outside
/// them. One keyframe is constant gravity; none is weightlessness.
struct Gravity {
  std::vector<double> time;                   ///< s, increasing
  std::vector<Eigen::Vector3d> acceleration;  ///< m/s², one a keyframe
  Oscillation oscillation{};                  ///< m/s², on top of them
  Eigen::Vector3d at(double t) const { return over_time(time, acceleration, oscillation, t); }
  /// The strongest of its keyframes and its amplitude, m/s²; 0 without any, for a weightless scene
  /// has no scale of its own.
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
