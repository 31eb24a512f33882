// SPDX-License-Identifier: BSD-3-Clause
#include "solver/scene/element_constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

namespace stiction {
namespace {

ElementConstants numbered(std::size_t element) {
  const Real base = static_cast<Real>(100 * element);
  ElementConstants constants;
  for (int k = 0; k < 9; ++k) constants.inverse_rest_edges[k] = base + static_cast<Real>(k);
  constants.mu_volume = base + 9;
  constants.lambda_volume = base + 10;
  constants.damping_time = base + 11;
  return constants;
}

TEST(BlocksOfConstants, GiveBackWhatWasPutIn) {
  constexpr std::size_t kCount = 3 * BlocksOfConstants::kBlock;
  BlocksOfConstants blocks;
  for (std::size_t e = 0; e < kCount; ++e) {
    EXPECT_EQ(blocks.size(), e);
    blocks.push_back(numbered(e));
    for (std::size_t read = 0; read <= e; ++read) {
      const ElementConstants constants = blocks[read], wanted = numbered(read);
      for (int k = 0; k < 9; ++k) {
        EXPECT_EQ(constants.inverse_rest_edges[k], wanted.inverse_rest_edges[k]);
      }
      EXPECT_EQ(constants.mu_volume, wanted.mu_volume);
      EXPECT_EQ(constants.lambda_volume, wanted.lambda_volume);
      EXPECT_EQ(constants.damping_time, wanted.damping_time);
    }
  }
}

// What a register reads of elements side by side.
TEST(BlocksOfConstants, LieNumberByNumberAndEndInTheLastElementAgain) {
  constexpr std::size_t kBlock = BlocksOfConstants::kBlock;
  BlocksOfConstants blocks;
  for (std::size_t e = 0; e < kBlock + 3; ++e) blocks.push_back(numbered(e));
  for (std::size_t e = 0; e < 2 * kBlock; ++e) {
    const Real* const first = blocks.first(e / kBlock * kBlock) + e % kBlock;
    const std::size_t of = std::min(e, kBlock + 2);
    for (std::size_t k = 0; k < BlocksOfConstants::kNumbers; ++k) {
      EXPECT_EQ(first[k * kBlock], static_cast<Real>(100 * of + k)) << e;
    }
  }
}

}  // namespace
}  // namespace stiction
