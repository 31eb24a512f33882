// SPDX-License-Identifier: BSD-3-Clause
#include "solver/gravity.h"

#include <algorithm>

namespace stiction {

Vec3 smooth_keyframes(const std::vector<double>& time, const std::vector<Vec3>& value, double t) {
  if (time.empty()) return Vec3::Zero();
  if (t <= time.front()) return value.front();
  if (t >= time.back()) return value.back();
  const auto after = std::upper_bound(time.begin(), time.end(), t);
  const auto k = static_cast<std::size_t>(after - time.begin());
  const double s = (t - time[k - 1]) / (time[k] - time[k - 1]);
  const double blend = s * s * s * (10.0 + s * (6.0 * s - 15.0));
  return value[k - 1] + blend * (value[k] - value[k - 1]);
}

}  // namespace stiction
