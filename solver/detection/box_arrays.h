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

namespace stiction {

/// Boxes side by side.
template <int Bytes>
struct BoxLanes {
  using Number = Lanes<Bytes>;
  Number low[3], high[3];

  BoxLanes() = default;
  STICTION_LANES_INLINE explicit BoxLanes(const Box3& all) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = Number(all.min()[axis]);
      high[axis] = Number(all.max()[axis]);
    }
  }

  /// Those that have a point in common with the other's, a bit each.
  STICTION_LANES_INLINE unsigned meeting(const BoxLanes& other) const {
    const auto along = [&](int axis) __attribute__((always_inline)) {
      return (low[axis] <= other.high[axis]) & (other.low[axis] <= high[axis]);
    };
    return (along(0) & along(1) & along(2)).bits();
  }
};

/// Boxes in arrays, m.
class BoxArrays {
 public:
  /// Makes place for so many, and a register more; those there are stay.
  void reserve(std::size_t count) {
    for (auto* side : {&low_, &high_}) {
      for (std::vector<Real>& numbers : *side) {
        numbers.resize(std::max(numbers.size(), count + static_cast<std::size_t>(kMostLanes)));
      }
    }
  }
  /// A register of them, from a place that there is on.
  template <int Bytes>
  STICTION_LANES_INLINE void set_lanes(std::size_t first, const BoxLanes<Bytes>& boxes) {
    unrolled<3>([&](auto axis) __attribute__((always_inline)) {
      store_numbers(boxes.low[axis], &low_[axis][first]);
      store_numbers(boxes.high[axis], &high_[axis][first]);
    });
  }
  Box3 operator[](std::size_t k) const {
    return {Vec3(low_[0][k], low_[1][k], low_[2][k]), Vec3(high_[0][k], high_[1][k], high_[2][k])};
  }
  void set(std::size_t k, const Box3& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis][k] = box.min()[static_cast<Eigen::Index>(axis)];
      high_[axis][k] = box.max()[static_cast<Eigen::Index>(axis)];
    }
  }
  void set(std::size_t k, const BoxArrays& other, std::size_t of_other) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis][k] = other.low_[axis][of_other];
      high_[axis][k] = other.high_[axis][of_other];
    }
  }
  /// Their sides along an axis, m.
  const Real* low(std::size_t axis) const { return low_[axis].data(); }
  const Real* high(std::size_t axis) const { return high_[axis].data(); }
  /// Calls use(k) for those from `begin` to before `end` that have a point in common with `box`, in their
  /// order. They are asked for by words of bits: where a loop ends after a few, register by register, the
  /// processor guesses wrong.
  template <int Bytes, class Use>
  STICTION_LANES_INLINE void for_each_meeting(std::size_t begin, std::size_t end, const Box3& box,
                                              const Use& use) const {
    const BoxLanes<Bytes> there(box);
    for (std::size_t first = begin; first < end; first += kWord) {
      const std::size_t count = std::min(end - first, kWord);
      for (std::uint64_t bits = meeting(first, count, there); bits != 0; bits &= bits - 1) {
        use(first + static_cast<std::size_t>(std::countr_zero(bits)));
      }
    }
  }

 private:
  static constexpr std::size_t kWord = 64;

  // Of `count` from `first` on, 1 to kWord, a bit each. The last register may reach beyond them.
  template <int Bytes>
  STICTION_LANES_INLINE std::uint64_t meeting(std::size_t first, std::size_t count,
                                              const BoxLanes<Bytes>& there) const {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < count; k += Lanes<Bytes>::kCount) {
      bits |= std::uint64_t{lanes<Bytes>(first + k).meeting(there)} << k;
    }
    return bits & (~std::uint64_t{0} >> (kWord - count));
  }
  template <int Bytes>
  STICTION_LANES_INLINE BoxLanes<Bytes> lanes(std::size_t first) const {
    BoxLanes<Bytes> boxes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      boxes.low[axis] = Lanes<Bytes>::load(&low_[axis][first]);
      boxes.high[axis] = Lanes<Bytes>::load(&high_[axis][first]);
    }
    return boxes;
  }

  std::array<std::vector<Real>, 3> low_, high_;  // along each axis, longer by a register
};

}  // namespace stiction
