// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "validation/core/case_run.h"

namespace stiction {

/// How often a question is answered with yes by runs that should be alike.
struct OutcomeFrequency {
  int yes = 0;
  int runs = 0;
  double share() const { return static_cast<double>(yes) / static_cast<double>(runs); }
};

/// Asks once of each scene whose numbers are a unit in the last place off (perturbations ulp/1 to
/// ulp/10): near a threshold no single run tells what comes of it. `ask` runs on the case's engine,
/// perturbed; cost, notes and passages are the run's.
OutcomeFrequency outcome_frequency(CaseRun& run, const std::function<bool(CaseRun&)>& ask);

}  // namespace stiction
