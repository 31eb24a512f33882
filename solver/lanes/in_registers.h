// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "solver/lanes/lane_width.h"
#include "solver/lanes/lanes.h"

namespace stiction {

// `work` is a lambda that is always inlined, so that it is compiled for the registers of its caller.

template <class Work>
STICTION_TARGET_4 void in_registers_of_four(const Work& work) {
  work();
}
/// Calls `work`, compiled for registers of four doubles where the processor's are so wide.
template <class Work>
void in_registers(int width, const Work& work) {
  if (width >= 4) {
    in_registers_of_four(work);
  } else {
    work();
  }
}

template <class Work>
void in_lanes_of_2(const Work& work) {
  work(std::integral_constant<int, 16>());
}
template <class Work>
STICTION_TARGET_4 void in_lanes_of_4(const Work& work) {
  work(std::integral_constant<int, 32>());
}
template <class Work>
STICTION_TARGET_8 void in_lanes_of_8(const Work& work) {
  work(std::integral_constant<int, 64>());
}
/// Calls `work` with the bytes of a register as a constant, compiled for registers of that size: of the
/// narrowest, up to `width` doubles, that has lanes for `count`. The bits are the same at each.
template <class Work>
void in_lanes(int count, int width, const Work& work) {
  while (width > 2 && count <= lanes_of(width / 2)) width /= 2;
  if (width == 8) {
    in_lanes_of_8(work);
  } else if (width == 4) {
    in_lanes_of_4(work);
  } else {
    in_lanes_of_2(work);
  }
}

}  // namespace stiction
