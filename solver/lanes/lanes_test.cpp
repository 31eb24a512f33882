// SPDX-License-Identifier: BSD-3-Clause
#include "solver/lanes/lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/lanes/lane_matrix.h"
#include "solver/lanes/lane_records.h"
#include "solver/lanes/lane_width.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

template <class T>
class EachRegister : public testing::Test {};
using Registers = testing::Types<Lanes<16>, Lanes<32>, Lanes<64>>;
TYPED_TEST_SUITE(EachRegister, Registers);

template <class L>
L counted(Real first, Real step) {
  L lanes;
  for (int lane = 0; lane < L::kCount; ++lane) lanes.value[lane] = first + step * Real(lane);
  return lanes;
}

TYPED_TEST(EachRegister, ReckonsEachLaneAsANumberAlone) {
  using L = TypeParam;
  const L a = counted<L>(0.3, 1.7), b = counted<L>(-2.1, 0.9);
  const L sum = a + b, difference = a - b, product = a * b, quotient = a / b, minus = -a,
          root = sqrt(a);
  const L chosen = choose(a < b * b, a, b), below = choose_below(a, b * b, a, b),
          least = lesser(a, b), most = greater(a, b);
  for (int lane = 0; lane < L::kCount; ++lane) {
    const Real x = a[lane], y = b[lane];
    EXPECT_EQ(sum[lane], x + y);
    EXPECT_EQ(difference[lane], x - y);
    EXPECT_EQ(product[lane], x * y);
    EXPECT_EQ(quotient[lane], x / y);
    EXPECT_EQ(minus[lane], -x);
    EXPECT_EQ(root[lane], std::sqrt(x));
    EXPECT_EQ(chosen[lane], x < y * y ? x : y);
    EXPECT_EQ(below[lane], x < y * y ? x : y);
    EXPECT_EQ(least[lane], std::min(x, y));
    EXPECT_EQ(most[lane], std::max(x, y));
  }
}

TYPED_TEST(EachRegister, CountsWhereSomethingHolds) {
  using L = TypeParam;
  const L a = counted<L>(0, 1);
  EXPECT_TRUE(all(a < L(Real(L::kCount))));
  EXPECT_TRUE(none(a < L(Real(0))));
  EXPECT_FALSE(all(a < L(Real(1))));
  EXPECT_FALSE(none(a < L(Real(1))));
  EXPECT_TRUE(none(L(std::numeric_limits<Real>::quiet_NaN()) < a));
  EXPECT_TRUE(all_zero(a - a));
  const auto below = a < L(Real(1)), above = L(Real(0)) < a;
  EXPECT_TRUE(none(below & above));
  EXPECT_TRUE(all(below | above));
  for (int lane = 0; lane < L::kCount; ++lane) EXPECT_EQ(below[lane], lane == 0);
  constexpr unsigned kAll = (1U << L::kCount) - 1;
  EXPECT_EQ(below.bits(), 1U);
  EXPECT_EQ((~below).bits(), kAll - 1);
  EXPECT_EQ((a <= L(Real(1))).bits(), 3U & kAll);
  for (unsigned bits = 0; bits <= kAll; ++bits) EXPECT_EQ(L::Mask::of(bits).bits(), bits);
  for (std::size_t count = 1; count < 2 * L::kCount; ++count) {
    EXPECT_EQ(first_bits(~below, count), (kAll - 1) & ((1U << count) - 1)) << count;
  }
  for (int lane = 0; lane < L::kCount; ++lane) {
    L one(Real(0));
    one.value[lane] = 1;
    EXPECT_FALSE(all_zero(one)) << lane;
  }
}

TYPED_TEST(EachRegister, LoadsAndStoresRecords) {
  using L = TypeParam;
  constexpr int kCount = L::kCount;
  Real records[kCount][4];
  const Real* record[kCount];
  for (int lane = 0; lane < kCount; ++lane) {
    record[lane] = records[kCount - 1 - lane];  // in any order
    for (int k = 0; k < 4; ++k) records[kCount - 1 - lane][k] = Real(10 * lane + k);
  }
  L columns[4];
  load_records(record, columns);
  for (int lane = 0; lane < kCount; ++lane) {
    for (int k = 0; k < 4; ++k) EXPECT_EQ(columns[k][lane], 10 * lane + k) << lane << ", " << k;
  }
  FourNumbers back[kCount];
  store_records(columns[0], columns[1], columns[2], back);
  for (int lane = 0; lane < kCount; ++lane) {
    for (int k = 0; k < 3; ++k) EXPECT_EQ(back[lane][k], 10 * lane + k) << lane << ", " << k;
    EXPECT_EQ(back[lane][3], 0);
  }
}

// Differences before numbers are put together are those after, and what is transposed twice is as before.
TYPED_TEST(EachRegister, SubtractsAndTransposesRecords) {
  using Records = LaneRecords<sizeof(TypeParam)>;
  constexpr int kCount = TypeParam::kCount;
  Real a[kCount][4], b[kCount][4];
  const Real *of_a[kCount], *of_b[kCount];
  for (int lane = 0; lane < kCount; ++lane) {
    of_a[lane] = a[lane];
    of_b[lane] = b[kCount - 1 - lane];
    for (int k = 0; k < 4; ++k) {
      a[lane][k] = Real(100 * lane + 7 * k);
      b[kCount - 1 - lane][k] = Real(10 * lane + k);
    }
  }
  const Records difference = Records::load(of_a) - Records::load(of_b);
  const Records numbers = difference.transposed();
  FourNumbers back[kCount];
  numbers.transposed().store(back);
  unrolled<kCount>([&](auto lane) {
    for (int k = 0; k < 4; ++k) {
      const Real wanted = Real(90 * lane + 6 * k);
      EXPECT_EQ(numbers.part[k][lane], wanted) << lane << ", " << k;
      EXPECT_EQ(difference.template of_lane<lane>()[k], wanted) << lane << ", " << k;
      EXPECT_EQ(back[lane][k], wanted) << lane << ", " << k;
    }
  });
}

TYPED_TEST(EachRegister, LoadsTriplesAndNumbersAndStoresAllFour) {
  using L = TypeParam;
  constexpr int kCount = L::kCount;
  Real records[kCount][3];
  const Real *record[kCount], *number[kCount];
  for (int lane = 0; lane < kCount; ++lane) {
    record[lane] = records[kCount - 1 - lane];
    number[lane] = record[lane] + lane % 3;
    for (int k = 0; k < 3; ++k) records[kCount - 1 - lane][k] = Real(10 * lane + k);
  }
  L columns[3];
  load_triples(record, columns);
  const L one = load_numbers<sizeof(L)>(number);
  FourNumbers back[kCount];
  store_records(columns[0], columns[1], columns[2], one, back);
  for (int lane = 0; lane < kCount; ++lane) {
    for (int k = 0; k < 3; ++k) EXPECT_EQ(columns[k][lane], 10 * lane + k) << lane << ", " << k;
    EXPECT_EQ(one[lane], 10 * lane + lane % 3);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(back[lane][k], 10 * lane + k) << lane << ", " << k;
    EXPECT_EQ(back[lane][3], one[lane]);
  }
}

// Each lane has what its matrix alone would, to the bit; a sum of three is a + (b + c).
TYPED_TEST(EachRegister, HasMatricesOfNumbersAlone) {
  using L = TypeParam;
  LaneMatrix<L> a, b;
  for (int k = 0; k < 3; ++k) {
    const auto m = Real(k);
    a.column[k] = {counted<L>(Real(0.1) * m, Real(0.7)), counted<L>(Real(1.3), Real(-0.3) * m),
                   counted<L>(Real(-0.9), Real(0.11))};
    b.column[k] = {counted<L>(Real(0.7), Real(0.13)), counted<L>(Real(-0.2) * m, Real(0.4)),
                   counted<L>(Real(0.5) * m, Real(0.9))};
  }
  const auto product = [](const Mat3& x, const Mat3& y) {
    Mat3 xy;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        xy(i, j) = x(i, 0) * y(0, j) + (x(i, 1) * y(1, j) + x(i, 2) * y(2, j));
    }
    return xy;
  };
  const LaneMatrix<L> ab = a * b, transpose = a.transpose(), square = gram(a).whole(),
                      mixed = symmetric_product(a, b).whole(), cof = cofactor(a);
  for (int lane = 0; lane < L::kCount; ++lane) {
    const Mat3 x = one_of(a, lane), y = one_of(b, lane);
    const Mat3 xx = product(x.transpose(), x), xy = product(x.transpose(), y);
    const auto differs = [](const Mat3& one, const Mat3& other) { return (one - other).norm(); };
    EXPECT_EQ(differs(one_of(ab, lane), product(x, y)), 0);
    EXPECT_EQ(differs(one_of(transpose, lane), x.transpose()), 0);
    EXPECT_EQ(differs(one_of(square, lane), xx), 0);
    EXPECT_EQ(differs(one_of(mixed, lane), Real(0.5) * (xy + xy.transpose())), 0);
    EXPECT_EQ(gram(a).trace()[lane], xx(0, 0) + (xx(1, 1) + xx(2, 2)));
    for (int k = 0; k < 3; ++k) {
      const Vec3 u = x.col((k + 1) % 3), v = x.col((k + 2) % 3);
      EXPECT_EQ((one_of(cof, lane).col(k) - u.cross(v)).norm(), 0);
    }
  }
}

TEST(LaneWidth, IsOneThatTheProcessorHas) {
  const std::vector<int> widths = lane_widths();
  EXPECT_EQ(widths.front(), 2);
  EXPECT_EQ(chosen_lane_width(""), widths.back());
  for (const int width : widths) EXPECT_EQ(chosen_lane_width(std::to_string(width)), width);
  EXPECT_NE(std::find(widths.begin(), widths.end(), lane_width()), widths.end());
}

TEST(LaneWidth, RefusesAnotherInOneSentence) {
  std::string known;
  for (const int width : lane_widths())
    known += (known.empty() ? "" : ", ") + std::to_string(width);
  for (const std::string wanted : {"3", "16", "wide", "2 ", "-2"}) {
    EXPECT_EQ(test::refusal([&] { chosen_lane_width(wanted); }),
              "STICTION_WIDTH is '" + wanted + "', but this processor's registers hold " + known +
                  " doubles");
  }
}

}  // namespace
}  // namespace stiction
