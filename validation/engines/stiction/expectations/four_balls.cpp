// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Fig. 7, four balls.
#include "validation/engines/stiction/expectations/table.h"

namespace stiction {

namespace {

constexpr Cause kOldSinks{
    "kOldSinks",
    "the method before the paper, without post-correction: settled like the others, its balls "
    "still move at 1.3e-2 J (quiet 5e-5 J), and part as soon as the friction is lowered",
    kNoCorrection};

constexpr Cause kFewVertices{
    "kFewVertices",
    "with 162 vertices a ball two balls touch in about four, whose facets lie up to 0.087 rad from "
    "the line of centres: that shifts the critical μ by up to 0.52 · 0.087 = 0.045. Measured: it "
    "stands from 0.253 (quiet) and 0.278 (paper) on; with 252 and 362 vertices from 0.21 to 0.238",
    kVerticesAlone};

constexpr Cause kSlipsOn{
    "kSlipsOn",
    "the paper's contacts on 252 vertices go on sticking and slipping between the balls, at 3e-4 "
    "to "
    "3e-3 m/s (quiet 3e-6); the top ball sinks by 0.7 mm in 5 s, and the pressures, mean of a "
    "second, are out of balance by more than 1e-3 of the weight. With 362 vertices they balance",
    kScalarLeaves};

// The pyramid that engines are compared with, of the same modulus for all that deform.
constexpr Cause kSoftFacets{
    "kSoftFacets",
    "the bound is that of rigid, smooth balls. So soft ones need 0.2250: Hertz' patch brings their "
    "centres nearer by 5 % of a radius (soft_balls.h). What is needed beyond that falls with the "
    "facets: 0.0150 with balls of 362 vertices (--set ball=6), 0.0097 with 642. They touch in a "
    "few, up to 0.043 rad off the line of centres, for which up to 0.52 · 0.043 = 0.022 is due",
    kFacetsRoll};
constexpr Words kThreeSteps{
    "kThreeSteps",
    "steps of 1 and 0.9 give a critical μ of 0.23468 and 0.23467; those of 1, 0.95 and 0.9 let the "
    "top ball sink by 1.39, 1.10 and 1.27 mm: from 1 mm, which holds, to three times that spread "
    "above"};

constexpr Words kNoBalance{
    "kNoBalance", "no μ balances them: the limit analysis looks up to 10, and then says infinity"};

}  // namespace

// clang-format off
Expectations expectations_four_balls() {
  return {
      {"paper/fig7-four-balls", "method=old", "stands at μ = 0.24", {0, 0}, kShortfall, kOldSinks, kCount},
      {"paper/fig7-four-balls/threshold/n=4", "method=paper", "stands at μ = 0.24", {0, 0}, kShortfall, kFewVertices, kCount},
      {"paper/fig7-four-balls/threshold/n=4", "method=quiet", "stands at μ = 0.24", {0, 0}, kShortfall, kFewVertices, kCount},
      {"paper/fig7-four-balls/threshold/n=5", "method=paper", "least μ of its contacts above 0.24", {9.7, kInfinity}, kShortfall, kSlipsOn, kNoBalance},
      {"pile/four-balls/threshold", "method=quiet", "critical μ", {0.23, 0.24}, kShortfall, kSoftFacets, kThreeSteps},
      {"pile/four-balls/mu=0.24", "method=quiet", "top ball's sinking at μ = 0.24", {0.001, 0.0023}, kShortfall, kSoftFacets, kThreeSteps},
  };
}
// clang-format on

}  // namespace stiction
