// SPDX-License-Identifier: GPL-3.0-or-later
// Suite stability: which digits do not survive, and on which rung it ends.
#include "validation/engines/stiction/expectations/table.h"

namespace stiction {

namespace {

constexpr Cause kSweepOrder{
    "kSweepOrder",
    "contacts are swept in the order of bodies and of their vertices, and a sweep that takes away "
    "no more slip than 1e-7 g Δt is the last: another order ends at another such place. The box is "
    "clamped by contacts of both sides, so that places differ in the seventh digit",
    kSwept};
constexpr Cause kSinglePrecision{
    "kSinglePrecision",
    "coordinates round by 6e-8 of 0.1 m, which a step of 2e-4 s turns into 3e-5 m/s before sweeps, "
    "and 3e-9 m/s are left: rest asks for 1e-12",
    kRounds};
constexpr Cause kFlatElement{"kFlatElement",
                             "a tetrahedron of which the volume is below 1e-12 of its longest "
                             "edge's cube is refused as flat",
                             kRefused};

}  // namespace

// clang-format off
Expectations expectations_stability() {
  return {
      {"perturbed/paper/fig3-clamped-box", "method=quiet", "bodies renumbered", {7.6e-08, 7e-07}, kShortfall, kSweepOrder, kOneRun},
      {"perturbed/slab/rest/one", "method=quiet", "single precision", {0.7, 0.71}, kShortfall, kSinglePrecision, kCount},
      {"ladder/needle/thinness=1e-06", "method=quiet", "refused", {1, 1}, kShortfall, kFlatElement, kCount},
  };
}
// clang-format on

}  // namespace stiction
