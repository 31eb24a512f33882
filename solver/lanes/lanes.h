// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "solver/real.h"

// Functions on lanes are inlined into one that is compiled for the register's width (lane_width.h);
// none is called across a boundary where the width would matter.
#define STICTION_LANES_INLINE [[gnu::always_inline]] inline

namespace stiction {

/// A record of four numbers as one value. May stand for any struct of four.
using FourNumbers = Real __attribute__((vector_size(4 * sizeof(Real)), may_alias));

/// Half of one.
using TwoNumbers = Real __attribute__((vector_size(2 * sizeof(Real)), may_alias));

template <int Bytes>
struct LaneRegister;
template <>
struct LaneRegister<16> {
  using Numbers = Real __attribute__((vector_size(16)));
};
template <>
struct LaneRegister<32> {
  using Numbers = Real __attribute__((vector_size(32)));
};
template <>
struct LaneRegister<64> {
  using Numbers = Real __attribute__((vector_size(64)));
};

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

/// As many numbers as a register of `Bytes` bytes holds, that go through the same operations side by
/// side: one formula handles as many elements. Each lane has the bits that a single number would
/// have, at every width: nothing is fused, and no sum goes across lanes.
template <int Bytes>
struct Lanes {
  using Register = typename LaneRegister<Bytes>::Numbers;
  static constexpr int kCount = Bytes / static_cast<int>(sizeof(Real));

  /// Where something holds, lane by lane.
  struct Mask {
    using Flags = decltype(Register{} < Register{});
    Flags value;

    /// From and to a bit a lane, that of lane 0 the lowest.
    STICTION_LANES_INLINE static Mask of(unsigned bits) {
      using Flag = std::remove_reference_t<decltype(Flags{}[0])>;
      return {((Flags{} + static_cast<Flag>(bits)) & bit_of_lane().value) != Flags{}};
    }
    STICTION_LANES_INLINE unsigned bits() const {
      return static_cast<unsigned>(either<kCount>(value & bit_of_lane().value));
    }

    STICTION_LANES_INLINE friend Mask operator&(const Mask& a, const Mask& b) {
      return {a.value & b.value};
    }
    STICTION_LANES_INLINE friend Mask operator|(const Mask& a, const Mask& b) {
      return {a.value | b.value};
    }
    STICTION_LANES_INLINE Mask operator~() const { return {~value}; }
    STICTION_LANES_INLINE friend bool all(const Mask& where) {
      return where.bits() == (1U << kCount) - 1;
    }
    STICTION_LANES_INLINE friend bool none(const Mask& where) { return where.bits() == 0; }
    STICTION_LANES_INLINE bool operator[](int lane) const { return value[lane] != 0; }

   private:
    STICTION_LANES_INLINE static Mask bit_of_lane() {
      return [&]<std::size_t... kLane>(std::index_sequence<kLane...>)
          __attribute__((always_inline)) {
        return Mask{Flags{(1 << kLane)...}};
      }
      (std::make_index_sequence<kCount>());
    }
  };

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
    return {a.value < b.value};
  }
  STICTION_LANES_INLINE friend Mask operator<=(const Lanes& a, const Lanes& b) {
    return {a.value <= b.value};
  }
  /// `yes` where it holds, else `no`.
  STICTION_LANES_INLINE friend Lanes choose(const Mask& where, const Lanes& yes, const Lanes& no) {
    return of(where.value ? yes.value : no.value);
  }
  STICTION_LANES_INLINE friend bool all_zero(const Lanes& a) {
    bool zero = true;
    for (int lane = 0; lane < kCount; ++lane) zero = zero && a[lane] == 0;
    return zero;
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
inline Real choose(bool where, Real yes, Real no) { return where ? yes : no; }
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

/// Four numbers of each of as many records as there are lanes, number by number: what `columns[k]`
/// has in lane l is record[l][k].
template <int Bytes>
STICTION_LANES_INLINE void load_records(const Real* const* record, Lanes<Bytes>* columns) {
  constexpr int kCount = Lanes<Bytes>::kCount;
  if constexpr (kCount == 2) {
    typename Lanes<Bytes>::Register a, b, c, d;
    std::memcpy(&a, record[0], Bytes);
    std::memcpy(&b, record[1], Bytes);
    std::memcpy(&c, record[0] + 2, Bytes);
    std::memcpy(&d, record[1] + 2, Bytes);
    columns[0].value = __builtin_shufflevector(a, b, 0, 2);
    columns[1].value = __builtin_shufflevector(a, b, 1, 3);
    columns[2].value = __builtin_shufflevector(c, d, 0, 2);
    columns[3].value = __builtin_shufflevector(c, d, 1, 3);
  } else if constexpr (kCount == 4) {
    typename Lanes<Bytes>::Register a, b, c, d;
    std::memcpy(&a, record[0], Bytes);
    std::memcpy(&b, record[1], Bytes);
    std::memcpy(&c, record[2], Bytes);
    std::memcpy(&d, record[3], Bytes);
    const auto ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const auto ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const auto cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const auto cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    columns[0].value = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
    columns[1].value = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
    columns[2].value = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
    columns[3].value = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
  } else {
    Lanes<Bytes / 2> low[4], high[4];
    load_records(record, low);
    load_records(record + kCount / 2, high);
    for (int k = 0; k < 4; ++k) columns[k] = joined(low[k], high[k]);
  }
}

/// The same of records of three numbers, with nothing behind them.
template <int Bytes>
STICTION_LANES_INLINE void load_triples(const Real* const* record, Lanes<Bytes>* columns) {
  constexpr int kCount = Lanes<Bytes>::kCount;
  // By halves that overlap: x, y and y, z.
  const auto two = [record](int lane, int first) __attribute__((always_inline)) {
    TwoNumbers numbers;
    std::memcpy(&numbers, record[lane] + first, sizeof numbers);
    return numbers;
  };
  if constexpr (kCount == 2) {
    columns[0].value = __builtin_shufflevector(two(0, 0), two(1, 0), 0, 2);
    columns[1].value = __builtin_shufflevector(two(0, 0), two(1, 0), 1, 3);
    columns[2].value = __builtin_shufflevector(two(0, 1), two(1, 1), 1, 3);
  } else if constexpr (kCount == 4) {
    const auto ac_xy = __builtin_shufflevector(two(0, 0), two(2, 0), 0, 1, 2, 3);
    const auto bd_xy = __builtin_shufflevector(two(1, 0), two(3, 0), 0, 1, 2, 3);
    const auto ac_yz = __builtin_shufflevector(two(0, 1), two(2, 1), 0, 1, 2, 3);
    const auto bd_yz = __builtin_shufflevector(two(1, 1), two(3, 1), 0, 1, 2, 3);
    columns[0].value = __builtin_shufflevector(ac_xy, bd_xy, 0, 4, 2, 6);
    columns[1].value = __builtin_shufflevector(ac_xy, bd_xy, 1, 5, 3, 7);
    columns[2].value = __builtin_shufflevector(ac_yz, bd_yz, 1, 5, 3, 7);
  } else {
    Lanes<Bytes / 2> low[3], high[3];
    load_triples(record, low);
    load_triples(record + kCount / 2, high);
    for (int k = 0; k < 3; ++k) columns[k] = joined(low[k], high[k]);
  }
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

/// The way back: record[l] = {x, y, z, w} of lane l.
template <int Bytes>
STICTION_LANES_INLINE void store_records(const Lanes<Bytes>& x, const Lanes<Bytes>& y,
                                         const Lanes<Bytes>& z, const Lanes<Bytes>& w,
                                         FourNumbers* record) {
  constexpr int kCount = Lanes<Bytes>::kCount;
  using Register = typename Lanes<Bytes>::Register;
  Real* const to = reinterpret_cast<Real*>(record);
  const auto store = [to](const Register& numbers, int at) __attribute__((always_inline)) {
    std::memcpy(to + at, &numbers, Bytes);
  };
  if constexpr (kCount == 2) {
    store(__builtin_shufflevector(x.value, y.value, 0, 2), 0);
    store(__builtin_shufflevector(z.value, w.value, 0, 2), 2);
    store(__builtin_shufflevector(x.value, y.value, 1, 3), 4);
    store(__builtin_shufflevector(z.value, w.value, 1, 3), 6);
  } else if constexpr (kCount == 4) {
    const auto xy_even = __builtin_shufflevector(x.value, y.value, 0, 4, 2, 6);
    const auto xy_odd = __builtin_shufflevector(x.value, y.value, 1, 5, 3, 7);
    const auto zw_even = __builtin_shufflevector(z.value, w.value, 0, 4, 2, 6);
    const auto zw_odd = __builtin_shufflevector(z.value, w.value, 1, 5, 3, 7);
    store(__builtin_shufflevector(xy_even, zw_even, 0, 1, 4, 5), 0);
    store(__builtin_shufflevector(xy_odd, zw_odd, 0, 1, 4, 5), 4);
    store(__builtin_shufflevector(xy_even, zw_even, 2, 3, 6, 7), 8);
    store(__builtin_shufflevector(xy_odd, zw_odd, 2, 3, 6, 7), 12);
  } else {
    store_records(low_half(x), low_half(y), low_half(z), low_half(w), record);
    store_records(high_half(x), high_half(y), high_half(z), high_half(w), record + kCount / 2);
  }
}

/// Of three numbers, and a fourth that is 0.
template <int Bytes>
STICTION_LANES_INLINE void store_records(const Lanes<Bytes>& x, const Lanes<Bytes>& y,
                                         const Lanes<Bytes>& z, FourNumbers* record) {
  store_records(x, y, z, Lanes<Bytes>(Real(0)), record);
}

}  // namespace stiction
