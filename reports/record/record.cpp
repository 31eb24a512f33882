// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/record.h"

namespace stiction {

Verdict verdict_of(const Record& record) {
  const bool only_figures = record.checks.empty() && !record.figures.empty();
  return only_figures ? Verdict::kForInformation : combined_verdict(record.checks);
}

std::optional<double> fewest_digits(const Record& record) {
  std::optional<double> fewest;
  for (const Judgement& check : record.checks) {
    const bool judged = check.verdict == Verdict::kPass || check.verdict == Verdict::kFail;
    if (!judged || !check.digits) continue;
    if (!fewest || !(*check.digits >= *fewest)) fewest = check.digits;
  }
  return fewest;
}

}  // namespace stiction
