// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/box_block.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <limits>
#include <vector>

#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

constexpr std::size_t kBoxes = BoxBlock::kBoxes;
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

BoxArrays arrays_of(const std::vector<Box3>& boxes) {
  BoxArrays arrays;
  arrays.reserve(kBoxes);
  for (std::size_t k = 0; k < boxes.size(); ++k) arrays.set(k, boxes[k]);
  return arrays;
}

template <int Bytes>
BoxBlock block_of(const std::vector<Box3>& boxes) {
  BoxArrays arrays = arrays_of(boxes);
  BoxBlock block;
  Box3 all;
  for (const Box3& box : boxes) all.extend(box);
  const Box3 around = block.take<Bytes>(arrays, boxes.size());
  EXPECT_EQ(around.min(), all.min());
  EXPECT_EQ(around.max(), all.max());
  return block;
}

// Boxes within one of 1 m, `away` from the origin along each axis, m.
std::vector<Box3> random_boxes(std::size_t count, Real away, unsigned seed) {
  const Eigen::Matrix3Xd ends = test::noise(2 * static_cast<Eigen::Index>(count), 0.5, seed);
  std::vector<Box3> boxes;
  for (Eigen::Index k = 0; k < ends.cols(); k += 2) {
    Box3 box;
    for (const Eigen::Index end : {k, k + 1}) {
      box.extend(Vec3(ends.col(end)) + Vec3::Constant(away));
    }
    boxes.push_back(box);
  }
  return boxes;
}

// What it says of a point within the box around all, at each size of register.
unsigned holding(const std::vector<Box3>& boxes, const Vec3& x) {
  const unsigned bits = block_of<16>(boxes).holding(x);
  EXPECT_EQ(block_of<32>(boxes).holding(x), bits);
  EXPECT_EQ(block_of<64>(boxes).holding(x), bits);
  return bits;
}

// Points anywhere within the box around all, and on the sides of boxes.
std::vector<Vec3> points_of(const std::vector<Box3>& boxes, const Box3& around, unsigned seed) {
  std::vector<Vec3> points;
  const Eigen::Matrix3Xd anywhere = test::noise(20, 0.5, seed);
  for (Eigen::Index k = 0; k < anywhere.cols(); ++k) {
    const Vec3 along = Vec3(anywhere.col(k)) + Vec3::Constant(0.5);
    points.push_back((around.min() + along.cwiseProduct(around.sizes()))
                         .cwiseMax(around.min())
                         .cwiseMin(around.max()));
  }
  for (const Box3& box : boxes) {
    points.push_back(box.min());
    points.push_back(box.max());
  }
  return points;
}

TEST(BoxBlock, LosesNoPointAndTakesFewBeside) {
  for (const Real away : {0.0, 1e3, 1e9}) {
    // As far off as this, numbers have gaps, m, and a side that is made wider is rounded to one of them.
    const Real gap = away * std::numeric_limits<Real>::epsilon();
    for (std::size_t count = 1; count <= kBoxes; ++count) {
      const std::vector<Box3> boxes = random_boxes(count, away, static_cast<unsigned>(count));
      Box3 around;
      for (const Box3& box : boxes) around.extend(box);
      const Vec3 part = around.sizes() / 255 + Vec3::Constant(gap);
      for (const Vec3& x : points_of(boxes, around, 50)) {
        const unsigned bits = holding(boxes, x);
        EXPECT_EQ(bits >> count, 0u) << "there are no more";
        for (std::size_t k = 0; k < count; ++k) {
          const Box3 wider(boxes[k].min() - part, boxes[k].max() + part);
          const bool said = (bits >> k & 1) != 0;
          EXPECT_TRUE(said || !boxes[k].contains(x)) << k << " of " << count << ", " << away;
          EXPECT_TRUE(!said || wider.contains(x)) << k << " of " << count << ", " << away;
        }
      }
    }
  }
}

// A box without width, without end, or of what is no number makes no fault, and loses no point.
TEST(BoxBlock, TakesBoxesOfAnySize) {
  const Vec3 x = Vec3::Constant(0.5), here = Vec3::Constant(0.25);
  const Box3 point(x, x), unit(Vec3::Zero(), Vec3::Ones());
  const Box3 far(Vec3::Constant(-std::numeric_limits<Real>::max()),
                 Vec3::Constant(std::numeric_limits<Real>::max()));
  const Box3 endless(Vec3(-kInfinity, 0, 0), Vec3(1, kInfinity, 1));
  std::feclearexcept(FE_ALL_EXCEPT);
  EXPECT_EQ(holding({point}, x), 1u);
  EXPECT_EQ(holding({point, point}, x), 3u);
  EXPECT_EQ(holding({unit, point}, here), 1u);
  EXPECT_EQ(holding({endless, unit}, x), 3u);
  EXPECT_EQ(std::fetestexcept(FE_INVALID | FE_DIVBYZERO), 0);
  EXPECT_EQ(holding({far, unit}, x), 3u);
  const Box3 nothing(Vec3::Constant(std::numeric_limits<Real>::quiet_NaN()),
                     Vec3::Constant(std::numeric_limits<Real>::quiet_NaN()));
  BoxArrays arrays = arrays_of({unit, nothing, unit});
  BoxBlock block;
  block.take<16>(arrays, 3);
  EXPECT_EQ(block.holding(here) & 5u, 5u);
}

}  // namespace
}  // namespace stiction
