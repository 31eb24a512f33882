// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "benchmarks/track/measure/campaign.h"
#include "reports/screen/screen.h"

namespace stiction::track {

/// What was found, in one sentence, e.g. "HEAD~1 → present: 2 metrics are worse, 0 better, of 120."
std::string closing_sentence(const Outcome& outcome);

/// What was found, on a screen: the closing sentence, then what changed, worst first, with what it was
/// decided on and the command that measures it again. `recorded`: the history has both runs.
std::string summary(const Outcome& outcome, bool recorded, const Screen& screen);

/// A table for a terminal, worst first: what changed, and all times and instructions; every metric
/// with `all`. Ends with the closing sentence.
std::string table(const Outcome& outcome, bool all);

/// The same as Markdown, for a pull request.
std::string markdown(const Outcome& outcome, bool all);

/// Everything, as one JSON object (benchmarks/schema.md).
std::string json_text(const Outcome& outcome);

}  // namespace stiction::track
