// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <vector>

#include "solver/real.h"

namespace stiction {

/// What the elastic force of a tetrahedron reads beside its corners.
struct ElementConstants {
  Real inverse_rest_edges[9];  ///< Dₘ⁻¹, column major, 1/m
  Real mu_volume;              ///< second Lamé parameter × rest volume, J
  Real lambda_volume;          ///< first Lamé parameter × rest volume, J
  Real damping_time;           ///< β, s
};

/// Those of all elements of a scene, in blocks of as many as the widest register has lanes: number by
/// number, so that elements side by side read theirs as they lie. The places of a block that are left
/// have the last element's again.
class BlocksOfConstants {
 public:
  static constexpr std::size_t kBlock = 64 / sizeof(Real);  ///< elements
  static constexpr std::size_t kNumbers = sizeof(ElementConstants) / sizeof(Real);

  std::size_t size() const { return size_; }

  void push_back(const ElementConstants& constants) {
    if (size_ % kBlock == 0) blocks_.emplace_back();
    for (std::size_t e = size_; e < blocks_.size() * kBlock; ++e) write(e, constants);
    ++size_;
  }

  ElementConstants operator[](std::size_t element) const {
    Numbers numbers;
    const Real* const from = first(element);
    for (std::size_t k = 0; k < kNumbers; ++k) numbers[k] = from[k * kBlock];
    return std::bit_cast<ElementConstants>(numbers);
  }

  /// Where the first number of an element lies; each further one is kBlock numbers on.
  const Real* first(std::size_t element) const {
    return &blocks_[element / kBlock].number[0][element % kBlock];
  }

 private:
  using Numbers = std::array<Real, kNumbers>;
  struct alignas(64) Block {
    Real number[kNumbers][kBlock];
  };

  void write(std::size_t element, const ElementConstants& constants) {
    const auto numbers = std::bit_cast<Numbers>(constants);
    for (std::size_t k = 0; k < kNumbers; ++k) {
      blocks_[element / kBlock].number[k][element % kBlock] = numbers[k];
    }
  }

  std::vector<Block> blocks_;
  std::size_t size_ = 0;
};

}  // namespace stiction
