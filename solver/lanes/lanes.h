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

using OneRecord = Lanes<sizeof(FourNumbers)>;

/// Four numbers of each of as many records as there are lanes, in four registers: as they lie in
/// memory, or number by number. From four lanes on, register k has record k in its first four lanes,
/// record k + 4 in the next, and so on; of two lanes, registers 0 and 2 have the halves of a record.
template <int Bytes>
struct LaneRecords {
  static constexpr int kCount = Lanes<Bytes>::kCount;
  Lanes<Bytes> part[4];

  STICTION_LANES_INLINE static LaneRecords load(const Real* const* record) {
    LaneRecords records;
    for (int k = 0; k < 4; ++k) {
      if constexpr (kCount == 2) {
        std::memcpy(&records.part[k].value, record[k % 2] + k / 2 * 2, Bytes);
      } else {
        records.part[k] = every_fourth<Bytes>(record + k);
      }
    }
    return records;
  }
  STICTION_LANES_INLINE void store(FourNumbers* record) const {
    unrolled<kCount>([&](auto lane)
                         __attribute__((always_inline)) { record[lane] = of_lane<lane>().value; });
  }

  /// From records to numbers: register k has number k of record l in lane l. And back.
  STICTION_LANES_INLINE LaneRecords transposed() const {
    if constexpr (kCount == 2) {
      return {
          {shuffled<0, 2>(0, 1), shuffled<1, 3>(0, 1), shuffled<0, 2>(2, 3), shuffled<1, 3>(2, 3)}};
    } else {
      const LaneRecords by_twos{{shuffled<0, 4, 2, 6>(0, 1), shuffled<1, 5, 3, 7>(0, 1),
                                 shuffled<0, 4, 2, 6>(2, 3), shuffled<1, 5, 3, 7>(2, 3)}};
      return {{by_twos.template shuffled<0, 1, 4, 5>(0, 2),
               by_twos.template shuffled<0, 1, 4, 5>(1, 3),
               by_twos.template shuffled<2, 3, 6, 7>(0, 2),
               by_twos.template shuffled<2, 3, 6, 7>(1, 3)}};
    }
  }

  /// The record of a lane, where registers have records.
  template <int kLane>
  STICTION_LANES_INLINE OneRecord of_lane() const {
    if constexpr (kCount == 2) {
      return joined(part[kLane], part[kLane + 2]);
    } else {
      constexpr int kFrom = kLane / 4 * 4;
      const auto& of_some = part[kLane % 4].value;
      return OneRecord::of(
          __builtin_shufflevector(of_some, of_some, kFrom, kFrom + 1, kFrom + 2, kFrom + 3));
    }
  }

  STICTION_LANES_INLINE friend LaneRecords operator-(const LaneRecords& a, const LaneRecords& b) {
    return {{a.part[0] - b.part[0], a.part[1] - b.part[1], a.part[2] - b.part[2],
             a.part[3] - b.part[3]}};
  }

 private:
  template <int kBytes>
  STICTION_LANES_INLINE static Lanes<kBytes> every_fourth(const Real* const* record) {
    if constexpr (Lanes<kBytes>::kCount == 4) {
      Lanes<kBytes> numbers;
      std::memcpy(&numbers.value, record[0], kBytes);
      return numbers;
    } else {
      return joined(every_fourth<kBytes / 2>(record),
                    every_fourth<kBytes / 2>(record + Lanes<kBytes / 2>::kCount));
    }
  }

  // As many lanes at a time as are said, shuffled with those of the other register at the same place.
  template <int... kOf>
  STICTION_LANES_INLINE Lanes<Bytes> shuffled(int a, int b) const {
    constexpr int kSize = sizeof...(kOf), kFrom[] = {kOf...};
    return [&]<int... kLane>(std::integer_sequence<int, kLane...>) __attribute__((always_inline)) {
      return Lanes<Bytes>::of(
          __builtin_shufflevector(part[a].value, part[b].value,
                                  (kLane / kSize * kSize + kFrom[kLane % kSize] +
                                   (kFrom[kLane % kSize] < kSize ? 0 : kCount - kSize))...));
    }
    (std::make_integer_sequence<int, kCount>());
  }
};

/// Number by number: what `columns[k]` has in lane l is record[l][k].
template <int Bytes>
STICTION_LANES_INLINE void load_records(const Real* const* record, Lanes<Bytes>* columns) {
  const auto numbers = LaneRecords<Bytes>::load(record).transposed();
  for (int k = 0; k < 4; ++k) columns[k] = numbers.part[k];
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
  LaneRecords<Bytes>{{x, y, z, w}}.transposed().store(record);
}

/// Of three numbers, and a fourth that is 0.
template <int Bytes>
STICTION_LANES_INLINE void store_records(const Lanes<Bytes>& x, const Lanes<Bytes>& y,
                                         const Lanes<Bytes>& z, FourNumbers* record) {
  store_records(x, y, z, Lanes<Bytes>(Real(0)), record);
}

}  // namespace stiction
