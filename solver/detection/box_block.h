// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "solver/detection/box_arrays.h"
#include "solver/lanes/lanes.h"
#include "solver/lanes/packed_vec3.h"

namespace stiction {

/// Sixteen boxes, their sides a byte each: rounded down to 255ths of the box around all,
///
///   b(x) = ⌊(x − low)·255/(high − low)⌋
///
/// b never falls as x grows, round-off included, so no point is lost: l ≤ x ≤ h ⇒ b(l) ≤ b(x) ≤ b(h). A point
/// that is outside a box, but by less than a 255th of the box around all, may seem to be in it.
class alignas(sizeof(FourNumbers)) BoxBlock {
 public:
  static constexpr std::size_t kBoxes = 16;

  BoxBlock() {}  // of no boxes yet, and no zeros are written

  /// Takes the first `count` ≥ 1 boxes, up to kBoxes, for which `boxes` has place; those beyond `count` hold no
  /// point, and are overwritten. Returns the box around them. At every size of register the same.
  template <int Bytes>
  STICTION_LANES_INLINE Box3 take(BoxArrays& boxes, std::size_t count) {
    for (std::size_t k = count; k < kBoxes; ++k) boxes.set(k, boxes, 0);
    Box3 around;
    FourNumbers from{}, all_parts{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Real *const low = boxes.low(axis), *const high = boxes.high(axis);
      const Real least = picked<Bytes>(
          low, [](const auto& a, const auto& b)
                   __attribute__((always_inline)) { return choose_below(a, b, a, b); });
      const Real most = picked<Bytes>(
          high, [](const auto& a, const auto& b)
                    __attribute__((always_inline)) { return choose_below(a, b, b, a); });
      around.min()[static_cast<Eigen::Index>(axis)] = least;
      around.max()[static_cast<Eigen::Index>(axis)] = most;
      // A box without end has no parts: all of these hold all.
      const bool parted = most > least && std::isfinite(most - least);
      const Real parts = parted ? kParts / (most - least) : 0;
      from[axis] = parted ? least : 0;
      all_parts[axis] = parts;
      low_[axis] = parted ? parts_of<Bytes>(low, least, parts) : Sixteen{};
      high_[axis] = parted ? parts_of<Bytes>(high, least, parts) : ~Sixteen{};
    }
    from_ = from;
    parts_ = all_parts;
    for (std::size_t k = count; k < kBoxes; ++k) {
      low_[0][k] = 1;
      high_[0][k] = 0;
    }
    return around;
  }

  /// Those that may hold a point that is within the box around all, a bit each.
  STICTION_LANES_INLINE unsigned holding(const PackedVec3& x) const {
    const FourNumbers most = FourNumbers{} + kParts;
    const FourNumbers exact = (x.value - from_) * parts_;
    const auto part = reinterpret_cast<Sixteen>(to_words(exact < most ? exact : most));
    const auto along = [&](auto axis) __attribute__((always_inline)) {
      const Sixteen all = repeated<4 * axis>(part);
      return (low_[axis] <= all) & (all <= high_[axis]);
    };
    return bits_of(along(std::integral_constant<int, 0>()) &
                   along(std::integral_constant<int, 1>()) &
                   along(std::integral_constant<int, 2>()));
  }

 private:
  using Sixteen = std::uint8_t __attribute__((vector_size(kBoxes)));
  using FourWords = std::uint32_t __attribute__((vector_size(16)));
  static constexpr Real kParts = std::numeric_limits<std::uint8_t>::max();

  // What is no number is in the last part: the conversion has no fault.
  STICTION_LANES_INLINE static FourWords to_words(const FourNumbers& part) {
    return reinterpret_cast<FourWords>(__builtin_convertvector(part, FourInts));
  }

  // One byte in all places.
  template <int kByte>
  STICTION_LANES_INLINE static Sixteen repeated(const Sixteen& bytes) {
    return [&]<std::size_t... k>(std::index_sequence<k...>) __attribute__((always_inline)) {
      return __builtin_shufflevector(bytes, bytes, (kByte + 0 * static_cast<int>(k))...);
    }
    (std::make_index_sequence<kBoxes>());
  }

  // Of kBoxes numbers, the one that is picked from each two.
  template <int Bytes, class Pick>
  STICTION_LANES_INLINE static Real picked(const Real* x, const Pick& pick) {
    using Number = Lanes<Bytes>;
    Number best = Number::load(x);
    for (std::size_t k = Number::kCount; k < kBoxes; k += Number::kCount) {
      best = pick(best, Number::load(x + k));
    }
    return picked_lane(best, pick);
  }
  template <int Bytes, class Pick>
  STICTION_LANES_INLINE static Real picked_lane(const Lanes<Bytes>& of, const Pick& pick) {
    if constexpr (Bytes > 16) {
      return picked_lane(pick(low_half(of), high_half(of)), pick);
    } else {
      Real best = of[0];
      for (int lane = 1; lane < Lanes<Bytes>::kCount; ++lane) best = pick(best, of[lane]);
      return best;
    }
  }

  template <int Bytes>
  STICTION_LANES_INLINE static Sixteen parts_of(const Real* x, Real from, Real parts) {
    using Number = Lanes<Bytes>;
    const Number most = kParts;
    Real part[kBoxes];
    for (std::size_t k = 0; k < kBoxes; k += Number::kCount) {
      const Number exact = (Number::load(x + k) - Number(from)) * Number(parts);
      store_numbers(choose_below(exact, most, exact, most), part + k);
    }
    // Each of four boxes in turn comes to a byte of one word, and the transpose puts them in order: the
    // compiler's own way from numbers to bytes goes one by one.
    const auto four = [&](int k) __attribute__((always_inline)) {
      FourNumbers numbers;
      std::memcpy(&numbers, part + 4 * k, sizeof(numbers));
      return to_words(numbers) << 8 * k;
    };
    const auto mixed = reinterpret_cast<Sixteen>(four(0) | four(1) | four(2) | four(3));
    return __builtin_shufflevector(mixed, mixed, 0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11,
                                   15);
  }

  // Of each eight flags, each 0 or all ones, one bit; the product brings them together in the last byte.
  template <class Flags>
  STICTION_LANES_INLINE static unsigned bits_of(const Flags& flags) {
    std::uint64_t half[2];
    std::memcpy(half, &flags, sizeof(half));
    const auto of = [](std::uint64_t eight) __attribute__((always_inline)) {
      return static_cast<unsigned>((eight & 0x8040201008040201) * 0x0101010101010101 >> 56);
    };
    return of(half[0]) | of(half[1]) << 8;
  }

  // Along each axis.
  Sixteen low_[3], high_[3];
  FourNumbers from_, parts_;  // m, 1/m
};

}  // namespace stiction
