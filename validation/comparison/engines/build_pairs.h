// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/screen/screen.h"
#include "validation/comparison/engines/answers.h"

namespace stiction {

// An engine beside another build of it, such as double beside single precision: what the arithmetic
// costs in digits, and what it buys in CPU time, with everything else the same.

/// The same answer of both, with the same configuration and effort.
struct AnswerPair {
  std::size_t question = 0;                      ///< among those asked
  std::size_t effort = 0;                        ///< rung of the ladder; 0: the usual
  std::optional<double> error{}, build_error{};  ///< magnitudes; nothing where it broke
  double seconds = 0.0, build_seconds = 0.0;     ///< CPU time
  /// CPU time of the engine over that of the build; NaN where one of them broke.
  double speed() const;
};

/// What a row of another build is compared with, answer by answer.
struct BuildPairs {
  EngineRow own, build;
  std::vector<AnswerPair> answers{};  ///< in the order of the questions, then of the efforts
};

/// One for each row of another build whose engine was asked in the same configuration.
std::vector<BuildPairs> build_pairs(const EngineAnswers& answers);

/// On the screen: error and CPU time of both, for each question with a curve at the least and the
/// most effort; then all answers in a sentence. Empty where there is no pair.
std::string builds_text(const EngineAnswers& answers, const Screen& screen);

/// The same of every question and effort, as tables in Markdown.
std::string builds_tables(const EngineAnswers& answers);

/// Of each pair the median, least and largest speed, over all answers and efforts.
std::vector<Figure> builds_figures(const EngineAnswers& answers);

/// "stiction_single · quiet beside stiction · quiet: …": a sentence for each pair.
std::vector<std::string> builds_findings(const EngineAnswers& answers);

}  // namespace stiction
