// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "solver/lanes/lane_register.h"

namespace stiction {

/// Of `kCount` whole numbers, their bits together.
template <int kCount, class Flags>
STICTION_LANES_INLINE auto either(const Flags& flags) {
  if constexpr (kCount == 2) {
    return flags[0] | flags[1];
  } else {
    return [&]<std::size_t... kLane>(std::index_sequence<kLane...>) __attribute__((always_inline)) {
      return either<kCount / 2>(__builtin_shufflevector(flags, flags, kLane...) |
                                __builtin_shufflevector(flags, flags, (kCount / 2 + kLane)...));
    }
    (std::make_index_sequence<kCount / 2>());
  }
}

/// Where something holds, lane by lane.
template <int Bytes>
struct LaneMask {
  using Register = typename LaneRegister<Bytes>::Numbers;
  using Flags = decltype(Register{} < Register{});
  static constexpr int kCount = Bytes / static_cast<int>(sizeof(Real));
  Flags value;

  /// From and to a bit a lane, that of lane 0 the lowest.
  STICTION_LANES_INLINE static LaneMask of(unsigned bits) {
    using Flag = std::remove_reference_t<decltype(Flags{}[0])>;
    return {((Flags{} + static_cast<Flag>(bits)) & bit_of_lane().value) != Flags{}};
  }
  STICTION_LANES_INLINE unsigned bits() const {
    return static_cast<unsigned>(either<kCount>(value & bit_of_lane().value));
  }

  STICTION_LANES_INLINE friend LaneMask operator&(const LaneMask& a, const LaneMask& b) {
    return {a.value & b.value};
  }
  STICTION_LANES_INLINE friend LaneMask operator|(const LaneMask& a, const LaneMask& b) {
    return {a.value | b.value};
  }
  STICTION_LANES_INLINE LaneMask operator~() const { return {~value}; }
  STICTION_LANES_INLINE bool operator[](int lane) const { return value[lane] != 0; }

 private:
  STICTION_LANES_INLINE static LaneMask bit_of_lane() {
    return [&]<std::size_t... kLane>(std::index_sequence<kLane...>) __attribute__((always_inline)) {
      return LaneMask{Flags{(1 << kLane)...}};
    }
    (std::make_index_sequence<kCount>());
  }
};

/// By halves: outside a function that is compiled for AVX-512, the compiler takes what is compared for
/// flags as wide as numbers, which AVX-512 has none of, and would compare lane by lane.
template <>
struct LaneMask<64> {
  using Half = LaneMask<32>;
  static constexpr int kCount = 2 * Half::kCount;
  Half low, high;

  STICTION_LANES_INLINE static LaneMask of(unsigned bits) {
    return {Half::of(bits), Half::of(bits >> Half::kCount)};
  }
  STICTION_LANES_INLINE unsigned bits() const { return low.bits() | high.bits() << Half::kCount; }

  STICTION_LANES_INLINE friend LaneMask operator&(const LaneMask& a, const LaneMask& b) {
    return {a.low & b.low, a.high & b.high};
  }
  STICTION_LANES_INLINE friend LaneMask operator|(const LaneMask& a, const LaneMask& b) {
    return {a.low | b.low, a.high | b.high};
  }
  STICTION_LANES_INLINE LaneMask operator~() const { return {~low, ~high}; }
  STICTION_LANES_INLINE bool operator[](int lane) const {
    return lane < Half::kCount ? low[lane] : high[lane - Half::kCount];
  }
};

/// The bits of the first `count` lanes; others are not looked at.
template <int Bytes>
STICTION_LANES_INLINE unsigned first_bits(const LaneMask<Bytes>& where, std::size_t count) {
  constexpr std::size_t kLanes = LaneMask<Bytes>::kCount;
  return count < kLanes ? where.bits() & ((1U << count) - 1) : where.bits();
}
template <int Bytes>
STICTION_LANES_INLINE bool none(const LaneMask<Bytes>& where) {
  if constexpr (Bytes == 64) {
    return none(where.low | where.high);
  } else {
    return where.bits() == 0;
  }
}
template <int Bytes>
STICTION_LANES_INLINE bool all(const LaneMask<Bytes>& where) {
  return none(~where);
}

}  // namespace stiction
