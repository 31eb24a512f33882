// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reports/record.h"

namespace stiction {

/// Correct digits of a value: −log10(|error| / |scale|), between 0 and 16; 16 when there is no
/// error, 0 when the value is no number.
double correct_digits(double error, double scale);

/// Fills in a check's error, digits and verdict. A check whose verdict is `kShown` or
/// `kNotApplicable` keeps it.
void judge(Check& check, double tolerance_scale);

}  // namespace stiction
