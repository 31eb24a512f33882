// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Fig. 6, non-convex objects in a basket.
#include "validation/expectations/table.h"

namespace stiction {

namespace {

constexpr Words kBursts{
    "kBursts",
    "both halves of the paper's method are needed for it: ξ on quiet contacts and a stored vector on "
    "the paper's contacts show no late spikes (seed 1). 28 % of its loaded contacts slip at the end"};
constexpr Words kSecant{
    "kSecant",
    "the secant sets going as much as it stills: 1.35e-7 J are left, with ξ = 1 1.25e-7, with the "
    "fixed point 7.2e-10 and with quiet 6.7e-12 J (seed 1)"};
constexpr Words kOldThrows{
    "kOldThrows",
    "the paper's own contrast, Fig. 6: without post-correction energy is injected at each contact, "
    "and objects fly out of the basket"};
constexpr Words kSeeds{"kSeeds", "from the tolerance to three times the largest of several seeds"};
constexpr Words kDiverges{
    "kDiverges", "from far beyond any rest, to infinity: whether it diverges depends on the seed"};

}  // namespace

// clang-format off
Expectations expectations_basket() {
  return {
      {"paper/fig6-basket/objects=20", "method=old", "farthest way of an object in the window", {0.05, kInfinity}, kLimit, kOldThrows, kDiverges},
      {"paper/fig6-basket/objects=20", "method=old", "mean kinetic energy at rest ÷ that with ξ = 1", {1000, kInfinity}, kLimit, kOldThrows, kDiverges},
      {"paper/fig6-basket/objects=20", "method=paper", "late spikes: largest kinetic energy ÷ mean before", {2.1, 84}, kLimit, kBursts, kSeeds},
      {"paper/fig6-basket/objects=20", "method=paper rule=secant", "mean kinetic energy at rest ÷ that with ξ = 1", {0.011, 100}, kLimit, kSecant, kSeeds},
      {"paper/fig6-basket/objects=20", "method=paper rule=secant", "late spikes: largest kinetic energy ÷ mean before", {2.1, 84}, kLimit, kBursts, kSeeds},
  };
}
// clang-format on

}  // namespace stiction
