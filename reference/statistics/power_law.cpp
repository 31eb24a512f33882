// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/statistics/power_law.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace stiction::reference {

namespace {

std::vector<double> logarithms(const std::vector<double>& values) {
  std::vector<double> logs;
  for (const double value : values) {
    if (!(value > 0.0) || !std::isfinite(value)) {
      throw std::invalid_argument("A power law is fitted to positive, finite numbers.");
    }
    logs.push_back(std::log(value));
  }
  return logs;
}

}  // namespace

PowerLaw fit_power_law(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() != y.size()) throw std::invalid_argument("A power law needs a y for each x.");
  const std::vector<double> log_x = logarithms(x), log_y = logarithms(y);
  if (log_x.empty() ||
      *std::min_element(x.begin(), x.end()) == *std::max_element(x.begin(), x.end())) {
    throw std::invalid_argument("A power law needs two different x.");
  }
  double constant, slope, variance_constant, covariance, variance_slope, residual;
  gsl_fit_linear(log_x.data(), 1, log_y.data(), 1, x.size(), &constant, &slope, &variance_constant,
                 &covariance, &variance_slope, &residual);
  PowerLaw law{slope, std::exp(constant), std::numeric_limits<double>::infinity()};
  if (x.size() > 2) {
    const double t = gsl_cdf_tdist_Pinv(0.975, static_cast<double>(x.size()) - 2.0);
    law.exponent_margin = t * std::sqrt(variance_slope);
  }
  return law;
}

}  // namespace stiction::reference
