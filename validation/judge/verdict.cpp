// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/judge/verdict.h"

#include <algorithm>
#include <cmath>

#include "solver/demand.h"

namespace stiction {

namespace {
// A double holds no more.
constexpr double kMostDigits = 16.0;
}  // namespace

double correct_digits(double error, double scale) {
  if (!std::isfinite(error)) return 0.0;
  if (error == 0.0) return kMostDigits;
  return std::clamp(-std::log10(std::abs(error) / std::abs(scale)), 0.0, kMostDigits);
}

void judge(Check& check, double tolerance_scale, Verdict in_band) {
  const double difference = check.value - check.expected;
  // Digits of a quantity whose answer is zero count from its scale: 1 unit unless the case says.
  const double scale = check.scale != 1.0 || check.expected == 0.0 ? check.scale : check.expected;
  demand(scale != 0.0, "a check's scale is not zero");
  check.scale = std::abs(scale);
  check.error = check.relative ? difference / check.scale : difference;
  check.digits = correct_digits(difference, check.scale);
  if (check.verdict == Verdict::kShown || check.verdict == Verdict::kNotApplicable) return;
  const bool holds = std::abs(check.error) <= check.tolerance * tolerance_scale;
  if (!check.band) {
    check.verdict = holds ? Verdict::kPass : Verdict::kFail;
    return;
  }
  demand(in_band == Verdict::kLimit || in_band == Verdict::kRefuted, "a band has a verdict");
  const bool inside = check.value >= check.band->low && check.value <= check.band->high;
  check.verdict = inside && !holds ? in_band : Verdict::kFail;
}

}  // namespace stiction
