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

/// Calls use(k) for the places of the bits that are set, the lowest first.
template <class Use>
STICTION_LANES_INLINE void for_each_bit(std::uint64_t bits, const Use& use) {
  for (; bits != 0; bits &= bits - 1) use(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Boxes in arrays, m. A register that begins at one of them may be read.
class BoxArrays {
 public:
  void reserve(std::size_t count) {
    for (auto* side : {&low_, &high_}) {
      for (std::vector<Real>& numbers : *side) {
        numbers.resize(std::max(numbers.size(), count + static_cast<std::size_t>(kMostLanes)));
      }
    }
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
  template <int Bytes>
  STICTION_LANES_INLINE void set_lanes(std::size_t first, const BoxLanes<Bytes>& boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      store_numbers(boxes.low[axis], &low_[axis][first]);
      store_numbers(boxes.high[axis], &high_[axis][first]);
    }
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
  // Those from `begin` to before `end`, at most 64, that have a point in common with what is in all lanes of
  // `there`: a bit each.
  template <int Bytes>
  STICTION_LANES_INLINE std::uint64_t meeting(std::size_t begin, std::size_t end,
                                              const BoxLanes<Bytes>& there) const {
    constexpr std::size_t kCount = Lanes<Bytes>::kCount;
    std::uint64_t bits = 0;
    for (std::size_t k = begin; k < end; k += kCount) {
      bits |= std::uint64_t{lanes<Bytes>(k).meeting(there)} << (k - begin);
    }
    return bits & (~std::uint64_t{0} >> (64 - (end - begin)));
  }

 private:
  std::array<std::vector<Real>, 3> low_, high_;  // along each axis
};

}  // namespace stiction
