// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "validation/comparison/engines/answers.h"

namespace stiction {

/// Engine × question: an aligned table in Markdown. A cell is how far an answer is off; "–" what an
/// engine lacks, "broke" where it failed, "never" where it has no answer. In as many tables below each other as `width`
/// letters a line ask for, 0: in one.
std::string engine_matrix(const EngineAnswers& answers, std::size_t width = 0);

/// The cheapest way to an error below each of some bounds, a line a question and bound: engine,
/// configuration and CPU time, with our own solver's behind. Empty without a curve.
std::string cheapest_ways(const EngineAnswers& answers);

/// What the answers say in plain words, first where another engine is better or cheaper than ours.
std::vector<std::string> engine_findings(const EngineAnswers& answers);

/// "4.2e-13", "+0.0012": a short error, signed where it can be below 0.
std::string short_error(const Question& question, double error);

/// Bounds of the errors for which the cheapest way is looked for.
inline constexpr double kErrorBounds[] = {1e-2, 1e-4, 1e-6};

}  // namespace stiction
