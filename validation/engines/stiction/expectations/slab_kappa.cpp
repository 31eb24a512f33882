// SPDX-License-Identifier: GPL-3.0-or-later
// slab/kappa: what fraction of a depth the normal forces close in a step, above its bound 1.
#include "validation/engines/stiction/expectations/table.h"

namespace stiction {

namespace {

constexpr Cause kCounts{
    "kCounts",
    "c_i of (5) counts the contacts that a vertex bears, not those it makes, so that it bounds "
    "nothing where vertices of both sides touch: κ is 1.72 there, and below 1 at half the step, "
    "where only the box's vertices touch",
    kUnboundedGain};
constexpr Words kUnstable{"kUnstable",
                          "from κ = 4/3, where z² − 2(1 − κ)z + (1 − κ) = 0 turns unstable (0.33 "
                          "above the bound), to 2.1, "
                          "the largest eigenvalue of the paper's gain that was met in any pose"};

}  // namespace

// clang-format off
Expectations expectations_slab_kappa() {
  return {
      {"slab/kappa", "method=paper", "largest κ above its bound", {0.33, 1.1}, kShortfall, kCounts, kUnstable},
  };
}
// clang-format on

}  // namespace stiction
