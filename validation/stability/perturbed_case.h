// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "validation/core/case.h"

namespace stiction {

/// The case run once as it is and once under each perturbation, untouched: a check a group of
/// perturbations, of how far what it measures scatters. Its name is "perturbed/" and that of the
/// case. `rests`: nothing moves at its end, so that its rounding does not add up.
Case perturbed_case(const Case& which, CaseSet set, bool rests);

/// Those of the suite "stability".
std::vector<Case> perturbed_cases(const std::vector<Case>& catalog);

}  // namespace stiction
