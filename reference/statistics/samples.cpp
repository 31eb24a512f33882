// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/statistics/samples.h"

#include <gsl/gsl_qrng.h>
#include <gsl/gsl_rng.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace stiction::reference {

namespace {

using Points = std::vector<std::vector<double>>;

Points random_points(std::size_t dimensions, std::size_t count, std::uint64_t seed) {
  const std::unique_ptr<gsl_rng, decltype(&gsl_rng_free)> random(gsl_rng_alloc(gsl_rng_mt19937),
                                                                 &gsl_rng_free);
  gsl_rng_set(random.get(), seed);
  Points points(count, std::vector<double>(dimensions));
  for (std::vector<double>& point : points) {
    for (double& x : point) x = gsl_rng_uniform(random.get());
  }
  return points;
}

Points sequence_points(const gsl_qrng_type* type, std::size_t dimensions, std::size_t count,
                       std::uint64_t skipped) {
  const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence(
      gsl_qrng_alloc(type, static_cast<unsigned int>(dimensions)), &gsl_qrng_free);
  Points points(count, std::vector<double>(dimensions));
  std::vector<double> none(dimensions);
  for (std::uint64_t k = 0; k < skipped; ++k) gsl_qrng_get(sequence.get(), none.data());
  for (std::vector<double>& point : points) gsl_qrng_get(sequence.get(), point.data());
  return points;
}

}  // namespace

std::vector<std::vector<double>> unit_samples(Sampling method, std::size_t dimensions,
                                              std::size_t count, std::uint64_t seed) {
  if (method == Sampling::kRandom) return random_points(dimensions, count, seed);
  const bool sobol = method == Sampling::kSobol;
  const gsl_qrng_type* const type = sobol ? gsl_qrng_sobol : gsl_qrng_reversehalton;
  if (dimensions < 1 || dimensions > type->max_dimension) {
    throw std::invalid_argument("the sequence has from 1 to " +
                                std::to_string(type->max_dimension) + " dimensions, not " +
                                std::to_string(dimensions));
  }
  return sequence_points(type, dimensions, count, seed);
}

}  // namespace stiction::reference
