// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/core/case_run.h"
#include "validation/estimate/threshold.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

/// Holds when the settled box comes to rest or is slowing down once the whole load is on.
///
/// An elastic body starts to slip while it is loaded, even below the critical slope, so 'moved less
/// than so much' would be biased. What separates the two sides of the threshold is the sign of its
/// acceleration, g (sin θ − μ cos θ): it is read between 1.1 s and 1.4 s, when vibrations have
/// decayed to 1e-12 m/s.
Holding incline_holds(CaseRun& run, const InclineSetup& setup, const Accuracy& accuracy = {});

/// The critical tan θ of `setup` (whose own tan θ is ignored): holds at 0.83 μ, slides at 1.21 μ,
/// and between them searched outwards from Coulomb's value.
Bracket incline_threshold(CaseRun& run, const InclineSetup& setup, double width,
                          const Accuracy& accuracy = {});

}  // namespace stiction
