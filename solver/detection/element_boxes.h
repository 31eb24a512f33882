// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/detection/boxes.h"
#include "solver/lanes/lanes.h"
#include "solver/scene/scene.h"

namespace stiction {

/// Boxes around elements of one body, in arrays, so that several are compared side by side.
class ElementBoxes {
 public:
  /// Bounds the body's elements at `x`, m, widens each box by `margin`, m, and keeps those that meet
  /// `within`, in the order of the elements. At one of `lane_widths`: the same at each.
  void bound(const Scene& scene, const Body& body, const std::vector<Vec3>& x, Real margin,
             const Box3& within, int width);

  std::size_t size() const { return element_.size(); }

  /// Calls use(element, box) for those that meet `around`, in their order, by registers of `Bytes`.
  template <int Bytes, class Use>
  STICTION_LANES_INLINE void for_each_at(const Box3& around, const Use& use) const {
    constexpr std::size_t kCount = Lanes<Bytes>::kCount;
    static_assert(kBlock % kCount == 0);
    for (std::size_t begin = 0; begin < size(); begin += kBlock) {
      if (apart(block_[begin / kBlock], around)) continue;
      const std::size_t end = std::min(begin + kBlock, size());
      for (std::size_t first = begin; first < end; first += kCount) {
        for (unsigned bits = meeting<Bytes>(around, first, end); bits != 0; bits &= bits - 1) {
          const std::size_t k = first + static_cast<std::size_t>(std::countr_zero(bits));
          use(element_[k], box(k));
        }
      }
    }
  }

 private:
  // What is next in number is near in space: so many are asked for by one box around all at first.
  static constexpr std::size_t kBlock = 16;

  // Of the boxes from `first` on, below `end`: a bit each.
  template <int Bytes>
  STICTION_LANES_INLINE unsigned meeting(const Box3& around, std::size_t first,
                                         std::size_t end) const {
    using Number = Lanes<Bytes>;
    const auto along = [&](std::size_t axis) __attribute__((always_inline)) {
      const Number low = Number::load(&low_[axis][first]), high = Number::load(&high_[axis][first]);
      const auto of_axis = static_cast<Eigen::Index>(axis);
      return (low <= Number(around.max()[of_axis])) & (Number(around.min()[of_axis]) <= high);
    };
    return first_bits(along(0) & along(1) & along(2), end - first);
  }

  Box3 box(std::size_t k) const {
    return {Vec3(low_[0][k], low_[1][k], low_[2][k]), Vec3(high_[0][k], high_[1][k], high_[2][k])};
  }

  template <int Bytes>
  void bound_side_by_side(const Scene& scene, const Body& body, const std::vector<Vec3>& x,
                          Real margin, const Box3& within);

  std::array<std::vector<Real>, 3> low_, high_;  // along each axis, m; longer by a register
  std::vector<std::int32_t> element_;
  std::vector<Box3> block_;  // around kBlock of them in turn
};

}  // namespace stiction
