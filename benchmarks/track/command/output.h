// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "benchmarks/track/measure/campaign.h"

namespace stiction::track {

/// What was found, in one sentence, e.g. "HEAD~1 → present: 2 metrics are worse, 0 better, of 120."
std::string closing_sentence(const Outcome& outcome);

/// A table for a terminal, worst first: what changed, and all times and instructions; every metric
/// with `all`. Ends with the closing sentence.
std::string table(const Outcome& outcome, bool all);

/// The same as Markdown, for a pull request.
std::string markdown(const Outcome& outcome, bool all);

/// Everything, as one JSON object (benchmarks/schema.md).
std::string json_text(const Outcome& outcome);

}  // namespace stiction::track
