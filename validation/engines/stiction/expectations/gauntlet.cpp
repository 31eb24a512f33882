// SPDX-License-Identifier: GPL-3.0-or-later
// gauntlet: bodies that balance on one point, about which they are free to turn.
#include "validation/engines/stiction/expectations/table.h"

namespace stiction {

namespace {

constexpr Cause kFreeToTurn{
    "kFreeToTurn",
    "a tip or a ridge in another's is pushed by two to six contacts at once, whose normals lean by "
    "up to 45° and which lie up to 2e-6 m apart, within their depths of 1e-6 to 8e-6 m: their "
    "horizontal forces leave a couple, of 5e-10 to 2e-8 m times the weight (5e-13 m in the rough "
    "groove), whose part about the vertical nothing opposes on one point. At the end the body "
    "turns "
    "about the vertical at 2.4e-6 to 8.8e-6 rad/s (slippery groove, ridge across ridge) and about "
    "any other axis at 1e-11 rad/s or less; exactly tip on tip, where three of six contacts slip, "
    "at 1.2e-4 and 1.4e-7 rad/s. With a single contact (tips 2 mm off each other) it rests. So "
    "does a tip on a vertex of a flat face, or not: by the draw of one ulp",
    kFreeTurn};
constexpr Words kDraws{"kDraws",
                       "what this scene gives as it is, with one ulp of noise, turned and "
                       "mirrored: from one of these to the next it differs as much"};

}  // namespace

// clang-format off
Expectations expectations_gauntlet() {
  return {
      {"gauntlet/spike-in-wedge", "method=quiet", "share at rest", {-0.5, 0.84}, kShortfall, kFreeToTurn, kFactorThree},
      {"gauntlet/spike-in-wedge", "method=quiet", "growth of kinetic energy", {0.54, 5}, kShortfall, kFreeToTurn, kFactorThree},
      {"gauntlet/spike-in-wedge/rough", "method=quiet", "share at rest", {0, 0.5}, kShortfall, kFreeToTurn, kDraws},
      {"gauntlet/spike-in-wedge/rough", "method=quiet", "growth of kinetic energy", {0.48, 4.6}, kShortfall, kFreeToTurn, kFactorThree},
      {"gauntlet/spike-on-spike", "method=quiet", "share at rest", {0.5, 0.5}, kShortfall, kFreeToTurn, kCount},
      {"gauntlet/spike-on-spike", "method=quiet", "drift at rest", {7e-10, 3.3e-06}, kShortfall, kFreeToTurn, kDraws},
      {"gauntlet/spike-on-spike", "method=quiet", "fastest contact slip", {2.6e-10, 6.8e-09}, kShortfall, kFreeToTurn, kFactorThree},
      {"gauntlet/spike-on-spike", "method=quiet", "growth of kinetic energy", {0.49, 4.6}, kShortfall, kFreeToTurn, kFactorThree},
      {"gauntlet/spike-on-spike", "method=quiet", "contact force beside the weight", {9e-11, 3e-05}, kShortfall, kFreeToTurn, kDraws},
      {"gauntlet/vertex-on-flat", "method=quiet", "share at rest", {0.6, 0.7}, kShortfall, kFreeToTurn, kCount},
      {"gauntlet/vertex-on-flat", "method=quiet", "growth of kinetic energy", {0.7, 1.7}, kShortfall, kFreeToTurn, kDraws},
      {"gauntlet/wedge-on-wedge", "method=quiet", "share at rest", {0, 0}, kShortfall, kFreeToTurn, kCount},
      {"gauntlet/wedge-on-wedge", "method=quiet", "growth of kinetic energy", {0.54, 5}, kShortfall, kFreeToTurn, kFactorThree},
  };
}
// clang-format on

}  // namespace stiction
