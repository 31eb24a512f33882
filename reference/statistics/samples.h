// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stiction::reference {

enum class Sampling {
  kSobol,   ///< low-discrepancy [AntonovSaleev1979], up to 40 dimensions; the seed skips points
  kHalton,  ///< low-discrepancy, scrambled as GSL's reverse Halton sequence; up to 1229 dimensions
  kRandom   ///< independent, by GSL's Mersenne twister
};

/// `count` points of the unit cube, each of `dimensions` numbers in [0, 1), in GSL's order; the same
/// call gives the same points. Throws std::invalid_argument for a dimension that the sequence hasn't
/// got.
std::vector<std::vector<double>> unit_samples(Sampling method, std::size_t dimensions,
                                              std::size_t count, std::uint64_t seed);

}  // namespace stiction::reference
