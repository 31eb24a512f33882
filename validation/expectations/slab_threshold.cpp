// SPDX-License-Identifier: GPL-3.0-or-later
// The critical slope of a box on a deformable slab.
#include "validation/expectations/table.h"

namespace stiction {

namespace {

constexpr Words kCreepsBelow{
    "kCreepsBelow",
    "a box that the scalar ξ holds creeps at 1e-5 m/s on every slope, for ξ leaves slip across ũ "
    "(compare, frozen/slab): the search finds the slope at which the creep has grown, not the one "
    "at "
    "which friction gives. Quiet's slopes hold at 1.3e-14 m/s"};
constexpr Words kTenthDegrees{
    "kTenthDegrees",
    "0.3° either way: a verdict on creep, of which one was turned by half the step"};

}  // namespace

// clang-format off
Expectations expectations_slab_threshold() {
  return {
      {"slab/threshold", "method=paper", "critical slope, rigid limit", {25.9, 26.5}, kRefuted, kCreepsBelow, kTenthDegrees},
      {"slab/threshold", "method=paper", "fastest creep of the slopes that hold", {3.3e-06, 3e-05}, kRefuted, kCreepsBelow, kOneRun},
      {"slab/threshold", "method=paper", "verdicts that half the step or twice the time turns", {1, 1}, kRefuted, kCreepsBelow, kCount},
      {"slab/threshold", "method=paper", "fastest creep of the slope that holds, at half the step and from then to twice the time", {3.4e-06, 3.2e-05}, kRefuted, kCreepsBelow, kOneRun},
  };
}
// clang-format on

}  // namespace stiction
