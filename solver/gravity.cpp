// SPDX-License-Identifier: BSD-3-Clause
#include "solver/gravity.h"

#include <algorithm>

namespace stiction {

Vec3 Gravity::at(double t) const {
  if (time.empty()) return Vec3::Zero();
  if (t <= time.front()) return acceleration.front();
  if (t >= time.back()) return acceleration.back();
  const auto after = std::upper_bound(time.begin(), time.end(), t);
  const auto k = static_cast<std::size_t>(after - time.begin());
  const double s = (t - time[k - 1]) / (time[k] - time[k - 1]);
  const double blend = s * s * s * (10.0 + s * (6.0 * s - 15.0));
  return acceleration[k - 1] + blend * (acceleration[k] - acceleration[k - 1]);
}

}  // namespace stiction
