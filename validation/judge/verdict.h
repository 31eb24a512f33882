// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reports/record/record.h"

namespace stiction {

/// Correct digits of a value: −log10(|error| / |scale|), between 0 and 16; 16 when there is no
/// error, 0 when the value is no number.
double correct_digits(double error, double scale);

/// Fills in a check's error, digits and verdict. |error| ≤ tolerance holds. A check without a band
/// passes or fails. One with a band is expected not to hold: inside the band its verdict is
/// `in_band` (`kLimit` or `kRefuted`), outside on either side it fails, and it fails when it holds:
/// then the band hides nothing and has to go. NaN is in no band. A check whose verdict is `kShown`
/// or `kNotApplicable` keeps it.
void judge(Check& check, double tolerance_scale, Verdict in_band = Verdict::kLimit);

}  // namespace stiction
