// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Fig. 7, four balls.
#include "validation/expectations/table.h"

namespace stiction {

namespace {

constexpr Words kOldSinks{
    "kOldSinks", "the method before the paper, without post-correction, as all others over 5 s"};

constexpr Words kRolls{
    "kRolls",
    "balls of 162 vertices roll off their facets, whatever the method: the top ball sinks 25.9 "
    "(paper), 25.5 (secant) and 25.3 mm (quiet) in 5 s. Two balls touch in one to three vertices, "
    "none of which slips while they roll, and nothing resists rolling or spinning: as four rigid "
    "balls with one contact a pair have six motions without slip, all neutral. Over 0.3 s all "
    "stand"};

}  // namespace

// clang-format off
Expectations expectations_four_balls() {
  return {
      {"paper/fig7-four-balls", "method=paper", "stands at μ = 0.24", {0, 0}, kLimit, kRolls, kCount},
      {"paper/fig7-four-balls", "method=paper rule=secant", "stands at μ = 0.24", {0, 0}, kLimit, kRolls, kCount},
      {"paper/fig7-four-balls", "method=quiet", "stands at μ = 0.24", {0, 0}, kLimit, kRolls, kCount},
      {"paper/fig7-four-balls", "method=old", "stands at μ = 0.24", {0, 0}, kLimit, kOldSinks, kCount},
  };
}
// clang-format on

}  // namespace stiction
