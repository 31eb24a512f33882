// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/observe/energy_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stiction {

EnergyWatch::EnergyWatch(double begin, double end, double mass, double rest_speed)
    : begin_(begin),
      middle_(0.5 * (begin + end)),
      end_(end),
      floor_(0.5 * mass * rest_speed * rest_speed) {}

void EnergyWatch::add(double time, double kinetic) {
  if (time <= begin_ || time > end_ * (1.0 + 1e-12)) return;
  const int half = time <= middle_ ? 0 : 1;
  sum_[half] += kinetic;
  ++count_[half];
}

double EnergyWatch::first_half() const { return sum_[0] / static_cast<double>(count_[0]); }
double EnergyWatch::second_half() const { return sum_[1] / static_cast<double>(count_[1]); }

double EnergyWatch::growth() const {
  const double before = first_half(), after = second_half();
  if (!std::isfinite(before) || !std::isfinite(after)) {
    return std::numeric_limits<double>::infinity();
  }
  if (after <= floor_) return 0.0;
  return (after - before) / std::max(before, floor_);
}

double EnergyWatch::allowance() { return 3.0 / std::sqrt(static_cast<double>(kSamples)); }

}  // namespace stiction
