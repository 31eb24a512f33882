// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/engines/holding.h"

#include <algorithm>
#include <cmath>

namespace stiction {

Holding holding(const EngineAnswers& answers, const EngineRow& row) {
  Holding seen;
  for (const Question& question : answers.questions()) {
    const EngineAnswer answer = answers.of(question, row);
    const double error = answer.error.value_or(std::nan(""));
    if (question.id.rfind("creep", 0) == 0 && answer.applicable) {
      seen.creep_asked = true;
      seen.creep = answer.error ? std::max(seen.creep, std::abs(error)) : INFINITY;
    }
    if (question.answer != Answer::kDegrees || !answer.applicable) continue;
    seen.asked = true;
    // One that gives on every slope, or on none, has no bracket.
    seen.least = std::min(seen.least, std::isnan(error) ? -90.0 : error);
    seen.most = std::max(seen.most, std::isnan(error) ? 90.0 : error);
  }
  return seen;
}

}  // namespace stiction
