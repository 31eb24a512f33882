// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "validation/estimate/threshold.h"
#include "validation/problems/slopes/slab_problem.h"

namespace stiction {

/// How a box on one slope ended.
struct Descent {
  double slope = 0.0;                 // rad
  bool holds = false;                 // it rests, or creeps
  double creep = 0.0;                 // mean speed in the last window, m/s
  double excess = Holding::kUnknown;  // where it slides, see threshold.h, m/s²
  double until = 0.0;                 // s
};

/// The box is watched in windows until it has rested in two, has slid away, or does not get slower
/// in three running. Whether it holds so doesn't depend on how long one looks: just below the
/// critical slope it takes seconds to stop. Mean speeds, since a limit cycle makes the speed at one
/// moment a matter of luck.
Descent descend(CaseRun& run, const SlabSetup& setup, const Accuracy& accuracy = {});

/// What a search for the steepest slope that holds saw.
struct SlopeSearch {
  Bracket bracket;            // on θ, degrees
  std::vector<Descent> seen;  // in the order of the slope
  double creep = 0.0;         // the largest of the slopes that hold, m/s
};

/// Outwards from `guess`, first to a bracket of `coarse`. Where what holds creeps that is all: a
/// slope is told from the next one by how fast it creeps, and no finer bracket has a meaning.
SlopeSearch search_slope(CaseRun& run, const SlabSetup& flat, double expected, double guess,
                         double coarse, double width);

/// The box and slab of `slab/threshold`: off the middle, turned, no mesh line in common.
SlabSetup slab_of_slopes();

}  // namespace stiction
