// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/clamp_problem.h"

namespace stiction {

/// Least force of a clamp, against the balance of force and couple with Coulomb's law at the jaws,
///   N = n m g/(2 (a μ − Δh/w + t)).
/// The geometry is that of the loaded clamp, as measured: pressure centres Δh apart over the width
/// w; t = (vertical part of the normal force)/N, because the boxes have turned and the planes in
/// which friction acts are no longer vertical; and only the share a of the friction points up.
///
/// The formula is one of rigid bodies. What elasticity adds falls with 1/E (measured over a factor
/// of 16), so that the search is done at E and at 4 E, and the ratio of force and formula is
/// extrapolated to rigid bodies. `most` and `least` bracket the jaws' way at E, m; `width` is where
/// the bisection ends.
void check_clamp_threshold(CaseRun& run, const ClampSetup& setup, double most, double least,
                           double width);

}  // namespace stiction
