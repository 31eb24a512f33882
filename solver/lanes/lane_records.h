// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstring>
#include <utility>

#include "solver/lanes/lanes.h"

namespace stiction {

/// A record of four numbers.
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
        records.part[k] = Lanes<Bytes>::load(record[k % 2] + k / 2 * 2);
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
      return Lanes<kBytes>::load(record[0]);
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
