// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/stability/outcome_frequency.h"

#include "validation/stability/perturbation.h"
#include "validation/stability/perturbed_engine.h"

namespace stiction {

OutcomeFrequency outcome_frequency(CaseRun& run, const std::function<bool(CaseRun&)>& ask) {
  OutcomeFrequency found;
  for (const Perturbation& how : perturbations()) {
    if (!how.ulp) continue;
    Settings settings = run.settings();
    settings[kPerturbedSetting] = how.name;
    CaseRun part = run.nested({}, perturbed(run.engine(), how), std::move(settings));
    found.yes += ask(part) ? 1 : 0;
    ++found.runs;
    run.include(part.record(), true);
  }
  return found;
}

}  // namespace stiction
