// SPDX-License-Identifier: GPL-3.0-or-later
// The critical slope of a box on a deformable slab.
#include "validation/engines/stiction/expectations/table.h"

namespace stiction {

namespace {

constexpr Cause kCreepsBelow{
    "kCreepsBelow",
    "a box that the scalar ξ holds creeps at 1e-5 m/s on every slope, for ξ leaves slip across ũ "
    "(compare, frozen/slab): the search finds the slope at which the creep has grown, not the one "
    "at "
    "which friction gives. Quiet's slopes hold at 1.3e-14 m/s",
    kScalarLeaves};
constexpr Words kTenthDegrees{
    "kTenthDegrees",
    "0.3° either way: a verdict on creep, of which one was turned by half the step"};

constexpr Cause kCreepsFine{
    "kCreepsFine",
    "the scalar ξ leaves slip across ũ: on this mesh what holds creeps at 5e-9 to 8e-9 m/s, on "
    "slab/threshold's at 1e-5. Quiet's slopes hold below 1e-13 m/s",
    kScalarLeaves};
constexpr Cause kStaleForce{
    "kStaleForce",
    "friction's force is kept where contact was lost, and counts again where it closes: with "
    "memory=reset and all else alike (method=paper) the same box holds up to 0.01° below theory. "
    "Below theory slopes hold and don't by turns, half the step turns them, and which of them a "
    "search ends at is luck",
    kStale};
constexpr Words kNowhere{
    "kNowhere",
    "the last slope that the search tries, 2° below theory: the box still slides on it"};
constexpr Words kSomewhere{"kSomewhere", "anywhere from there to theory: luck"};

}  // namespace

// clang-format off
Expectations expectations_slab_threshold() {
  return {
      {"slab/threshold", "method=paper", "critical slope, rigid limit", {25.9, 26.5}, kRefuted, kCreepsBelow, kTenthDegrees},
      {"slab/threshold", "method=paper", "fastest creep of the slopes that hold", {3.3e-06, 3e-05}, kRefuted, kCreepsBelow, kOneRun},
      {"slab/threshold", "method=paper", "verdicts that half the step or twice the time turns", {1, 1}, kRefuted, kCreepsBelow, kCount},
      {"slab/threshold", "method=paper", "fastest creep of the slope that holds, at half the step and from then to twice the time", {3.4e-06, 3.2e-05}, kRefuted, kCreepsBelow, kOneRun},
      {"slab/threshold", "method=paper rule=secant", "critical slope, rigid limit", {25.9, 26.5}, kRefuted, kCreepsBelow, kTenthDegrees},
      {"slab/threshold", "method=paper rule=secant", "fastest creep of the slopes that hold", {3.2e-06, 3e-05}, kRefuted, kCreepsBelow, kOneRun},
      {"slab/threshold", "method=paper rule=secant", "verdicts that half the step or twice the time turns", {1, 1}, kRefuted, kCreepsBelow, kCount},
      {"slab/threshold", "method=paper rule=secant", "fastest creep of the slope that holds, at half the step and from then to twice the time", {3e-06, 2.8e-05}, kRefuted, kCreepsBelow, kOneRun},
      {"slab/threshold", "memory=keep method=paper", "critical slope, rigid limit", {24.5, 24.6}, kShortfall, kStaleForce, kNowhere},
      {"slab/threshold/fine", "method=paper", "fastest creep of the slopes that hold", {1.5e-09, 1.5e-08}, kRefuted, kCreepsFine, kOneRun},
      {"slab/threshold/fine", "method=paper rule=secant", "fastest creep of the slopes that hold", {1.5e-09, 1.5e-08}, kRefuted, kCreepsFine, kOneRun},
      {"slab/threshold/fine", "method=paper", "fastest creep of the slope that holds, at half the step and from then to twice the time", {2.6e-09, 2.6e-08}, kRefuted, kCreepsFine, kOneRun},
      {"slab/threshold/fine", "method=paper rule=secant", "fastest creep of the slope that holds, at half the step and from then to twice the time", {2.6e-09, 2.6e-08}, kRefuted, kCreepsFine, kOneRun},
      {"slab/threshold/fine", "memory=keep method=paper", "critical slope, rigid limit", {24.5, 26.6}, kShortfall, kStaleForce, kSomewhere},
      {"slab/threshold/fine", "memory=keep method=paper", "fastest creep of the slopes that hold", {9e-08, 8.2e-07}, kShortfall, kStaleForce, kOneRun},
      {"slab/threshold/fine", "memory=keep method=paper", "verdicts that half the step or twice the time turns", {1, 2}, kShortfall, kStaleForce, kCount},
      {"slab/threshold/fine", "memory=keep method=paper", "fastest creep of the slope that holds, at half the step and from then to twice the time", {1.1e-05, 0.00011}, kShortfall, kStaleForce, kOneRun},
  };
}
// clang-format on

}  // namespace stiction
