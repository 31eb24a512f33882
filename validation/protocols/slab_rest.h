// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/problems/slopes/slab_problem.h"

namespace stiction {

inline constexpr double kRestSlip = 1e-12;    ///< m/s
inline constexpr double kRestEnergy = 1e-24;  ///< J
inline constexpr double kStallWindow = 0.3;   ///< s

/// How a run ended.
struct SlabOutcome {
  bool at_rest = false;  ///< all samples of the last half second are below both bounds
  SlabSample last;
  double fastest_slip = 0.0;  ///< largest of the samples of the last half second, m/s
  double kinetic = 0.0;       ///< … J
};

/// Runs until the box has rested for half a second, or until nothing decays any more: when twice running the
/// highest kinetic energy seen in a window of `kStallWindow` is more than half that of the window
/// before. Elastic vibration falls by more than a decade in that time, a limit cycle or a slide
/// doesn't; so a run that would still come to rest is not cut off. Gives up at 8 s in any case.
/// `history` may be null. `over`: what a study lays over the run's settings.
SlabOutcome bring_to_rest(CaseRun& run, const SlabSetup& setup, const Settings& over,
                          SlabSeries* history);

/// How far a box goes on a slab on which it shall rest: from 4 s to 14 s.
void check_slab_drift(CaseRun& run, const SlabSetup& setup);

}  // namespace stiction
