// SPDX-License-Identifier: BSD-3-Clause
#include "solver/lanes/packed_vec3.h"

#include <gtest/gtest.h>

#include "solver/lanes/lane_width.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

TEST(PackedVec3, GivesTheBitsOfVec3AtEveryWidth) {
  const auto numbers = test::noise(100, 1.0, 5);
  for (const int width : lane_widths()) {
    for (int k = 0; k + 1 < 100; ++k) {
      const Vec3 a = numbers.col(k).cast<Real>(), b = numbers.col(k + 1).cast<Real>();
      Vec3 sum, difference, product, scaled, size, larger, lesser;
      Real dot = 0, norm = 0;
      in_registers(
          width, [&]() __attribute__((always_inline)) {
            // A fourth that no sum may see.
            const PackedVec3 none(FourNumbers{0, 0, 0, test::kNaN});
            const PackedVec3 p = PackedVec3(a).with_fourth(none),
                             q = PackedVec3(b).with_fourth(none);
            sum = vector_cast<Vec3>(p + q);
            difference = vector_cast<Vec3>(p - q);
            product = vector_cast<Vec3>(p * q);
            scaled = vector_cast<Vec3>(p.y() * q);
            size = vector_cast<Vec3>(p.cwiseAbs());
            larger = vector_cast<Vec3>(p.cwiseMax(q));
            lesser = vector_cast<Vec3>(p.cwiseMin(q));
            dot = p.dot(q);
            norm = p.norm();
          });
      EXPECT_EQ(sum, a + b);
      EXPECT_EQ(difference, a - b);
      EXPECT_EQ(product, a.cwiseProduct(b));
      EXPECT_EQ(scaled, a.y() * b);
      EXPECT_EQ(size, a.cwiseAbs());
      EXPECT_EQ(larger, a.cwiseMax(b));
      EXPECT_EQ(lesser, a.cwiseMin(b));
      EXPECT_EQ(dot, a.dot(b));
      EXPECT_EQ(norm, a.norm());
    }
  }
}

TEST(PackedVec3, GoesToARecordAndBackWhole) {
  for (const int width : lane_widths()) {
    for (std::size_t at = 0; at < 4; ++at) {  // numbers may lie anywhere
      alignas(4 * sizeof(Real)) Real record[8] = {}, other[8] = {}, bare[8] = {};
      for (std::size_t k = 0; k < 4; ++k) record[at + k] = Real(2 + k);
      Vec3 fourths;
      in_registers(
          width, [&]() __attribute__((always_inline)) {
            const PackedVec3 v = PackedVec3::load(record + at);
            fourths = vector_cast<Vec3>(v.fourths());
            v.with_fourth(PackedVec3::Zero()).store(other + at);
            v.without_fourth().store(bare + at);
          });
      EXPECT_EQ(fourths, Vec3(5, 5, 5));
      for (std::size_t k = 0; k < 8; ++k) {
        const bool inside = k >= at && k < at + 3;
        EXPECT_EQ(other[k], inside ? Real(2 + k - at) : 0) << k << " of those at " << at;
        EXPECT_EQ(bare[k], other[k]) << k << " of those at " << at;
      }
    }
  }
}

}  // namespace
}  // namespace stiction
