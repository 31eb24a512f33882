// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/threshold.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stiction {

double Bracket::width() const { return std::abs(fails - holds); }

bool Bracket::contains(double value) const {
  return value >= std::min(holds, fails) && value <= std::max(holds, fails);
}

Bracket find_threshold(double first, double last, double width,
                       const std::function<bool(double)>& holds_at) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!holds_at(first)) return {kNone, kNone, 1};
  if (holds_at(last)) return {kNone, kNone, 2};
  Bracket bracket{first, last, 2};
  while (bracket.width() > width) {
    const double middle = bracket.middle();
    if (middle == bracket.holds || middle == bracket.fails) break;  // no number lies between
    ++bracket.evaluations;
    (holds_at(middle) ? bracket.holds : bracket.fails) = middle;
  }
  return bracket;
}

}  // namespace stiction
