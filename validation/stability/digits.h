// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"
#include "validation/stability/perturbed_engine.h"

namespace stiction {

/// A number that a run ends with.
struct Observation {
  std::string name;  ///< "critical slope", "position of 'box', x, at the end"
  std::string unit;  ///< SI
  double value = 0.0;
  double scale = 1.0;    ///< what digits count from, in `unit`, > 0
  bool is_check = true;  ///< of the case, else of a body's end
};

/// What a run of a case measured: the values of its checks that have a scale; and where and how fast
/// the bodies of each simulation were at its end, unless it is a search that takes many.
std::vector<Observation> observations_of(const Record& record, const PerturbedTrace& trace);

/// How far runs of a case are apart that should be alike.
struct Deviation {
  double relative = 0.0;  ///< σ/scale of the worst; ∞: a run lacks what the first has
  double absolute = 0.0;  ///< σ of it, in its unit
  std::string worst{};    ///< which, and what it came to: sentence without an end
};

/// Of runs that can't be compared, for this reason.
Deviation unbounded(const std::string& why);

/// σ is the corrected standard deviation of the runs. `runs`: two or more, each all that one
/// measured; `words`: how each was run. Ends of bodies are compared where each run has as many
/// simulations. A check that a run has not got is infinitely far off, unless they `may_lack` some:
/// another build of an engine is not held to all that the engine is held to.
Deviation deviation(const std::vector<std::vector<Observation>>& runs,
                    const std::vector<std::string>& words, bool may_lack = false);

}  // namespace stiction
