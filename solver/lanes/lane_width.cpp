// SPDX-License-Identifier: BSD-3-Clause
#include "solver/lanes/lane_width.h"

#include <algorithm>
#include <cstdlib>

#include "solver/demand.h"

namespace stiction {

std::vector<int> lane_widths() {
  std::vector<int> widths = {2};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) {
    widths.push_back(4);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl")) {
      widths.push_back(8);
    }
  }
#endif
  return widths;
}

int chosen_lane_width(const std::string& wanted) {
  const std::vector<int> widths = lane_widths();
  if (wanted.empty()) return widths.back();
  std::string known;
  for (const int width : widths) {
    if (wanted == std::to_string(width)) return width;
    known += (known.empty() ? "" : ", ") + std::to_string(width);
  }
  throw InputError("STICTION_WIDTH is '" + wanted + "', but this processor's registers hold " +
                   known + " doubles");
}

int lane_width() {
  static const int width = [] {
    const char* const wanted = std::getenv("STICTION_WIDTH");
    return chosen_lane_width(wanted == nullptr ? "" : wanted);
  }();
  return width;
}

}  // namespace stiction
