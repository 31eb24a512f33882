// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"
#include "validation/comparison/engines/questions.h"

namespace stiction {

/// Engine × question: an aligned table in Markdown, of records that engine_records() made. A cell
/// is how far an answer is off; "–" what an engine lacks, "broke" where it failed, "never" where it
/// has no answer. Order: as in the records.
std::string engine_matrix(const std::vector<Question>& questions, const std::vector<Record>& made);

/// The cheapest way to an error below each of some bounds, a line a question and bound: engine,
/// configuration and CPU time, with our own solver's behind.
std::string cheapest_ways(const std::vector<Question>& questions, const std::vector<Record>& made);

/// What the records say in plain words, first where another engine is better or cheaper than ours.
std::vector<std::string> engine_findings(const std::vector<Question>& questions,
                                         const std::vector<Record>& made);

/// "4.2e-13", "+0.0012": a short error, signed where it can be below 0.
std::string short_error(const Question& question, double error);

}  // namespace stiction
