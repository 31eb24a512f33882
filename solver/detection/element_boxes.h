// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/detection/box_arrays.h"
#include "solver/detection/box_block.h"
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

  /// Calls use(point, element) for each point and each box that holds it, and maybe some that it is just
  /// beside (box_block.h), those of a point in the order of the elements, by registers of `Bytes`. `points` are
  /// all in, and not looked up yet.
  template <int Bytes, class Use>
  STICTION_LANES_INLINE void for_each_holding(SpatialHash& points, const Use& use) {
    const Box3 around = points.build();
    const auto look_up = [&](std::size_t b) __attribute__((always_inline)) {
      const BoxBlock& block = block_[b];
      const std::int32_t* const element = &element_[b * BoxBlock::kBoxes];
      for (const std::uint32_t place : points.places_in<Bytes>(around_[b])) {
        const std::int32_t point = points.number(place);
        for (unsigned bits = block.holding(points.at(place)); bits != 0; bits &= bits - 1) {
          use(point, element[std::countr_zero(bits)]);
        }
      }
    };
    around_.for_each_meeting<Bytes>(0, block_.size(), around, look_up);
  }

 private:
  template <int Bytes>
  void bound_side_by_side(const Scene& scene, const Body& body, const std::vector<Vec3>& x,
                          Real margin, const Box3& within);

  BoxArrays box_;     // of each, until they are in blocks
  BoxArrays around_;  // each block: what is next in number is near in space
  std::vector<BoxBlock> block_;
  std::vector<std::int32_t> element_;
};

}  // namespace stiction
