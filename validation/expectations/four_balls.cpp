// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Fig. 7, four balls.
#include "validation/expectations/table.h"

namespace stiction {

namespace {

constexpr Words kOldSinks{
    "kOldSinks",
    "the method before the paper, without post-correction: settled like the others, its balls "
    "still move at 1.3e-2 J (quiet 5e-5 J), and part as soon as the friction is lowered"};

}  // namespace

// clang-format off
Expectations expectations_four_balls() {
  return {
      {"paper/fig7-four-balls", "method=old", "stands at μ = 0.24", {0, 0}, kLimit, kOldSinks, kCount},
  };
}
// clang-format on

}  // namespace stiction
