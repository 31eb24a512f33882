// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/estimate/threshold.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stiction {

double Bracket::width() const { return std::abs(fails - holds); }

bool Bracket::contains(double value) const {
  return value >= std::min(holds, fails) && value <= std::max(holds, fails);
}

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Bracket narrow(Bracket bracket, double width, const std::function<bool(double)>& holds_at) {
  while (bracket.width() > width) {
    const double middle = bracket.middle();
    if (middle == bracket.holds || middle == bracket.fails) break;  // no number lies between
    ++bracket.evaluations;
    (holds_at(middle) ? bracket.holds : bracket.fails) = middle;
  }
  return bracket;
}

Bracket find_threshold(double first, double last, double width,
                       const std::function<bool(double)>& holds_at) {
  if (!holds_at(first)) return {kNone, kNone, 1};
  if (holds_at(last)) return {kNone, kNone, 2};
  return narrow({first, last, 2}, width, holds_at);
}

Bracket find_threshold_near(double guess, double step, double reach, double width,
                            const std::function<bool(double)>& holds_at) {
  const bool holds = holds_at(guess);
  if (!holds) step = -step;
  const double end = guess + std::copysign(reach, step);
  int runs = 1;
  for (double inner = guess; inner != end; step *= 4.0) {
    const double next = inner + step;
    const double outer = std::abs(next - guess) < reach ? next : end;
    ++runs;
    if (holds_at(outer) != holds) {
      return narrow(holds ? Bracket{inner, outer, runs} : Bracket{outer, inner, runs}, width,
                    holds_at);
    }
    inner = outer;
  }
  return {kNone, kNone, runs};
}

}  // namespace stiction
