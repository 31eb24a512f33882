// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "reports/record/record.h"

namespace stiction {

/// Phrases about a check that several outputs share. Text from records is already `one_line`;
/// escaping for Markdown or XML is left to the caller.

/// "1.2e-05 m", or "1.2e-05 rel" when the error is relative.
std::string error_text(const Judgement& check);

/// The tolerance in the same spelling as the error.
std::string tolerance_text(const Judgement& check);

/// A share of the tolerance in short: "exact", "<0.01 %", "12 %", "320 ×", "3e+07 ×", "∞".
std::string share_text(double of_tolerance);
/// That of a check; empty where nothing is decided by it.
std::string share_text(const Judgement& check);

/// What broke: the reason, or "it broke at gain = -0.5, 2.3".
std::string failure_text(const Failure& failure);

/// "stopping distance: measured 0.31 m, expected 0.3 m (analytic), error 0.033 rel, tolerance 0.001
/// rel", and what its band says.
std::string check_sentence(const Judgement& check);

/// What a band says of the value, to follow a verdict or a value: ", as expected in [1e-6, 1e-5] m",
/// ", worse than expected [1e-6, 1e-5] m", ", better than known [1e-6, 1e-5] m: raise the bar".
/// Empty without a band.
std::string band_text(const Judgement& check);

/// "dt=0.001 rule=fixed-point"; empty for no settings.
std::string settings_text(const std::map<std::string, std::string>& settings);

}  // namespace stiction
