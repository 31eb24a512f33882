// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/detection/box_arrays.h"
#include "solver/detection/spatial_hash.h"
#include "solver/lanes/lanes.h"
#include "solver/scene/scene.h"

namespace stiction {

/// Boxes around elements of one body.
class ElementBoxes {
 public:
  /// Bounds the body's elements at `x`, m, widens each box by `margin`, m, and keeps those that meet
  /// `within`, in the order of the elements. At one of `lane_widths`: the same at each.
  void bound(const Scene& scene, const Body& body, const std::vector<Vec3>& x, Real margin,
             const Box3& within, int width);

  std::size_t size() const { return element_.size(); }

  /// Calls use(point, element) for each point and each box that holds it, those of a point in the order of
  /// the elements, by registers of `Bytes`. `points`, at `x`, m, are within `around`, and not looked up yet.
  template <int Bytes, class Use>
  STICTION_LANES_INLINE void for_each_holding(const Box3& around, SpatialHash& points,
                                              const std::vector<Vec3>& x, const Use& use) {
    if (points.points().size() <= kFew) {
      for_each_holding_few<Bytes>(around, points.points(), use);
    } else {
      points.build();
      for_each_holding_many<Bytes>(around, points, x, use);
    }
  }

 private:
  // What is next in number is near in space: so many are asked for by one box around all at first.
  static constexpr std::size_t kBlock = 16;

  // Of so many points each is compared with all boxes near them; of more, with those near it.
  static constexpr std::size_t kFew = 24;

  template <int Bytes, class Use>
  STICTION_LANES_INLINE void for_each_holding_few(const Box3& around,
                                                  std::span<const SpatialHash::Point> points,
                                                  const Use& use) {
    near_.resize(size());
    std::size_t count = 0;
    const auto note = [&](std::size_t k) __attribute__((always_inline)) { near_[count++] = k; };
    const auto note_block = [&](std::size_t b) __attribute__((always_inline)) {
      for_each_of_block<Bytes>(b, around, note);
    };
    block_.for_each_meeting<Bytes>(0, blocks(), around, note_block);
    near_box_.reserve(count);
    for (std::size_t k = 0; k < count; ++k) near_box_.set(k, box_, near_[k]);
    for (const SpatialHash::Point& point : points) {
      const auto holds = [&](std::size_t k) __attribute__((always_inline)) {
        use(point.number, element_[near_[k]]);
      };
      near_box_.for_each_meeting<Bytes>(0, count, Box3(point.x, point.x), holds);
    }
  }

  template <int Bytes, class Use>
  STICTION_LANES_INLINE void for_each_holding_many(const Box3& around, SpatialHash& points,
                                                   const std::vector<Vec3>& x, const Use& use) {
    const auto look_up = [&](std::size_t b) __attribute__((always_inline)) {
      for (const std::int32_t point : points.points_in<Bytes>(block_[b])) {
        const Vec3& there = x[static_cast<std::size_t>(point)];
        const auto holds = [&](std::size_t k) __attribute__((always_inline)) {
          use(point, element_[k]);
        };
        for_each_of_block<Bytes>(b, Box3(there, there), holds);
      }
    };
    block_.for_each_meeting<Bytes>(0, blocks(), around, look_up);
  }

  std::size_t blocks() const { return (size() + kBlock - 1) / kBlock; }

  // Calls use(k) for those of a block that meet `around`.
  template <int Bytes, class Use>
  STICTION_LANES_INLINE void for_each_of_block(std::size_t block, const Box3& around,
                                               const Use& use) const {
    const std::size_t begin = block * kBlock;
    box_.for_each_meeting<Bytes>(begin, std::min(begin + kBlock, size()), around, use);
  }

  template <int Bytes>
  void bound_side_by_side(const Scene& scene, const Body& body, const std::vector<Vec3>& x,
                          Real margin, const Box3& within);

  BoxArrays box_, block_;  // of each, and around kBlock of them in turn
  std::vector<std::int32_t> element_;
  // Scratch: places of those near, and their boxes.
  std::vector<std::size_t> near_;
  BoxArrays near_box_;
};

}  // namespace stiction
