// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "solver/lanes/lane_mask.h"

namespace stiction {

/// As many numbers as a register of `Bytes` bytes holds, that go through the same operations side by
/// side: one formula handles as many elements. Each lane has the bits that a single number would
/// have, at every width: nothing is fused, and no sum goes across lanes.
template <int Bytes>
struct Lanes {
  using Register = typename LaneRegister<Bytes>::Numbers;
  static constexpr int kCount = Bytes / static_cast<int>(sizeof(Real));

  using Mask = LaneMask<Bytes>;

  Register value;

  Lanes() = default;
  // Said, so that a copy is one move of the register: the compiler's own goes by halves, and what is
  // read whole after that waits for both.
  STICTION_LANES_INLINE Lanes(const Lanes& b) : value(b.value) {}
  STICTION_LANES_INLINE Lanes& operator=(const Lanes& b) {
    value = b.value;
    return *this;
  }
  STICTION_LANES_INLINE Lanes(Real all) : value(Register{} + all) {}

  STICTION_LANES_INLINE Real operator[](int lane) const { return value[lane]; }

  STICTION_LANES_INLINE static Lanes of(const Register& numbers) {
    Lanes lanes;
    lanes.value = numbers;
    return lanes;
  }
  /// Numbers that lie one after the other; `store_numbers` is the way back.
  STICTION_LANES_INLINE static Lanes load(const Real* from) {
    Lanes lanes;
    std::memcpy(&lanes.value, from, Bytes);
    return lanes;
  }
  STICTION_LANES_INLINE Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
  STICTION_LANES_INLINE Lanes& operator-=(const Lanes& b) { return *this = *this - b; }
  STICTION_LANES_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return of(a.value + b.value);
  }
  STICTION_LANES_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return of(a.value - b.value);
  }
  STICTION_LANES_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return of(a.value * b.value);
  }
  STICTION_LANES_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) {
    return of(a.value / b.value);
  }
  STICTION_LANES_INLINE friend Lanes operator-(const Lanes& a) { return of(-a.value); }
  STICTION_LANES_INLINE friend Mask operator<(const Lanes& a, const Lanes& b) {
    if constexpr (Bytes == 64) {
      return {low_half(a) < low_half(b), high_half(a) < high_half(b)};
    } else {
      return {a.value < b.value};
    }
  }
  STICTION_LANES_INLINE friend Mask operator<=(const Lanes& a, const Lanes& b) {
    if constexpr (Bytes == 64) {
      return {low_half(a) <= low_half(b), high_half(a) <= high_half(b)};
    } else {
      return {a.value <= b.value};
    }
  }
  /// `yes` where it holds, else `no`.
  STICTION_LANES_INLINE friend Lanes choose(const Mask& where, const Lanes& yes, const Lanes& no) {
    if constexpr (Bytes == 64) {
      return joined(choose(where.low, low_half(yes), low_half(no)),
                    choose(where.high, high_half(yes), high_half(no)));
    } else {
      return of(where.value ? yes.value : no.value);
    }
  }
  /// `yes` where a < b, else `no`: in one go, which takes no mask.
  STICTION_LANES_INLINE friend Lanes choose_below(const Lanes& a, const Lanes& b, const Lanes& yes,
                                                  const Lanes& no) {
    return of(a.value < b.value ? yes.value : no.value);
  }
  STICTION_LANES_INLINE friend Lanes lesser(const Lanes& a, const Lanes& b) {
    return choose_below(a, b, a, b);
  }
  STICTION_LANES_INLINE friend Lanes greater(const Lanes& a, const Lanes& b) {
    return choose_below(a, b, b, a);
  }
  STICTION_LANES_INLINE friend bool all_zero(const Lanes& a) {
    if constexpr (Bytes == 64) {
      return all_zero(low_half(a)) && all_zero(high_half(a));
    } else {
      return none(Mask{a.value != Register{}});
    }
  }
  STICTION_LANES_INLINE friend Lanes sqrt(Lanes a) {
    for (int lane = 0; lane < kCount; ++lane) a.value[lane] = std::sqrt(a.value[lane]);
    return a;
  }
};

/// Of the widest register.
inline constexpr int kMostLanes = Lanes<64>::kCount;

/// Of a register of so many doubles.
constexpr int lanes_of(int width) {
  return width * static_cast<int>(sizeof(double)) / static_cast<int>(sizeof(Real));
}

// What formulas ask of a single number beside arithmetic.
inline Real choose_below(Real a, Real b, Real yes, Real no) { return a < b ? yes : no; }
inline bool all_zero(Real x) { return x == 0; }

// Halves go by way of shuffles: what goes by way of memory, written in halves and read whole, waits
// for both.
template <std::size_t kFrom, int Bytes>
STICTION_LANES_INLINE Lanes<Bytes / 2> half_of(const Lanes<Bytes>& lanes) {
  return [&]<std::size_t... kLane>(std::index_sequence<kLane...>) __attribute__((always_inline)) {
    return Lanes<Bytes / 2>::of(
        __builtin_shufflevector(lanes.value, lanes.value, (kFrom + kLane)...));
  }
  (std::make_index_sequence<Lanes<Bytes / 2>::kCount>());
}
template <int Bytes>
STICTION_LANES_INLINE Lanes<Bytes / 2> low_half(const Lanes<Bytes>& lanes) {
  return half_of<0>(lanes);
}
template <int Bytes>
STICTION_LANES_INLINE Lanes<Bytes / 2> high_half(const Lanes<Bytes>& lanes) {
  return half_of<Lanes<Bytes / 2>::kCount>(lanes);
}
template <int Bytes>
STICTION_LANES_INLINE Lanes<2 * Bytes> joined(const Lanes<Bytes>& low, const Lanes<Bytes>& high) {
  return [&]<std::size_t... kLane>(std::index_sequence<kLane...>) __attribute__((always_inline)) {
    return Lanes<2 * Bytes>::of(__builtin_shufflevector(low.value, high.value, kLane...));
  }
  (std::make_index_sequence<Lanes<2 * Bytes>::kCount>());
}

/// Calls `work` with 0 … kCount − 1, each as a constant.
template <int kCount, class Work>
STICTION_LANES_INLINE void unrolled(const Work& work) {
  [&]<int... k>(std::integer_sequence<int, k...>) __attribute__((always_inline)) {
    (work(std::integral_constant<int, k>()), ...);
  }
  (std::make_integer_sequence<int, kCount>());
}

/// A number a lane, from anywhere.
template <int Bytes>
STICTION_LANES_INLINE Lanes<Bytes> load_numbers(const Real* const* number) {
  constexpr int kCount = Lanes<Bytes>::kCount;
  using Register = typename Lanes<Bytes>::Register;
  if constexpr (kCount == 2) {
    return Lanes<Bytes>::of(Register{*number[0], *number[1]});
  } else if constexpr (Bytes == 16) {
    return Lanes<Bytes>::of(Register{*number[0], *number[1], *number[2], *number[3]});
  } else {
    return joined(load_numbers<Bytes / 2>(number), load_numbers<Bytes / 2>(number + kCount / 2));
  }
}

/// The lanes one after the other.
template <int Bytes>
STICTION_LANES_INLINE void store_numbers(const Lanes<Bytes>& lanes, Real* to) {
  std::memcpy(to, &lanes.value, Bytes);
}

}  // namespace stiction
