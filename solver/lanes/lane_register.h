// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "solver/real.h"

// Functions on lanes are inlined into one that is compiled for the register's width (lane_width.h);
// none is called across a boundary where the width would matter.
#define STICTION_LANES_INLINE [[gnu::always_inline]] inline

namespace stiction {

/// A record of four numbers as one value. May stand for any struct of four.
using FourNumbers = Real __attribute__((vector_size(4 * sizeof(Real)), may_alias));

/// As many whole numbers, which numbers become by __builtin_convertvector, towards zero.
using FourInts = std::int32_t __attribute__((vector_size(4 * sizeof(std::int32_t))));

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

}  // namespace stiction
