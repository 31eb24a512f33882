// SPDX-License-Identifier: BSD-3-Clause
#include "solver/scene/gravity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stiction {

Eigen::Vector3d smooth_keyframes(const std::vector<double>& time,
                                 const std::vector<Eigen::Vector3d>& value, double t) {
  if (time.empty()) return Eigen::Vector3d::Zero();
  if (t <= time.front()) return value.front();
  if (t >= time.back()) return value.back();
  const auto after = std::upper_bound(time.begin(), time.end(), t);
  const auto k = static_cast<std::size_t>(after - time.begin());
  const double s = (t - time[k - 1]) / (time[k] - time[k - 1]);
  return value[k - 1] + smooth_step(s) * (value[k] - value[k - 1]);
}

Eigen::Vector3d Oscillation::at(double t) const {
  if (!(t > begins)) return Eigen::Vector3d::Zero();
  const double grown = t < full_from ? smooth_step((t - begins) / (full_from - begins)) : 1.0;
  const double angle = 2.0 * std::numbers::pi * frequency * (t - begins) + phase;
  return grown * std::sin(angle) * amplitude;
}

double Gravity::scale() const {
  double strongest = oscillation.amplitude.norm();
  for (const Eigen::Vector3d& a : acceleration) strongest = std::max(strongest, a.norm());
  return strongest;
}

double Drag::at(double t) const {
  if (t >= ends) return 0.0;
  if (t <= full_until) return rate;
  return rate * (1.0 - smooth_step((t - full_until) / (ends - full_until)));
}

}  // namespace stiction
