// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/limit/no_tension_column.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace stiction::reference {

namespace {

constexpr int kParts = 400;
constexpr int kIterations = 5000;
constexpr double kNone = std::numeric_limits<double>::infinity();

}  // namespace

double top_deflection(const Column& column, double tan_slope) {
  const double h = column.width, part = column.height / kParts;
  const double cosine = 1.0 / std::hypot(1.0, tan_slope), sine = tan_slope * cosine;
  const double weight = column.weight_density * h * h * part;
  const double second_moment = h * h * h * h / 12.0;
  std::vector<double> y(kParts + 1, 0.0), curvature(kParts + 1, 0.0);
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    // The weight of each part sits in its middle.
    double above = 0.0, sum_y = 0.0, sum_z = 0.0;
    for (int i = kParts; i >= 0; --i) {
      const auto k = static_cast<std::size_t>(i);
      if (i < kParts) {
        above += weight;
        sum_y += weight * 0.5 * (y[k] + y[k + 1]);
        sum_z += weight * part * (i + 0.5);
      }
      if (above == 0.0) continue;
      const double moment = cosine * (sum_y - above * y[k]) + sine * (sum_z - above * part * i);
      const double thrust = above * cosine;
      const double e = moment / thrust;
      if (e >= 0.5 * h) return kNone;
      curvature[k] =
          e <= h / 6.0
              ? moment / (column.youngs_modulus * second_moment)
              : 2.0 * thrust / (9.0 * column.youngs_modulus * h * std::pow(0.5 * h - e, 2));
    }
    double angle = 0.0, deflection = 0.0, change = 0.0;
    for (std::size_t k = 0; k < kParts; ++k) {
      const double turn = 0.5 * (curvature[k] + curvature[k + 1]) * part;
      deflection += (angle + 0.5 * turn) * part;
      angle += turn;
      change = std::max(change, std::abs(deflection - y[k + 1]));
      y[k + 1] = deflection;
    }
    if (change < 1e-10 * column.height) return y.back();
    if (!(std::abs(y.back()) < column.height)) return kNone;
  }
  return kNone;
}

double critical_tan(const Column& column) {
  const double rigid = column.width / column.height;
  double low = 0.0, high = rigid;
  while (high - low > 1e-4 * rigid) {
    const double middle = 0.5 * (low + high);
    (std::isfinite(top_deflection(column, middle)) ? low : high) = middle;
  }
  return low;
}

}  // namespace stiction::reference
