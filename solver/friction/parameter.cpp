// SPDX-License-Identifier: BSD-3-Clause
#include "solver/friction/parameter.h"

#include <cmath>
#include <sstream>

namespace stiction {

std::string range_words(const RuleParameter& parameter) {
  if (parameter.off) return std::string(parameter.off) + " or " + parameter.on;
  const bool below = std::isfinite(parameter.low), above = std::isfinite(parameter.high);
  std::ostringstream words;
  if (below && above) {
    words << (parameter.open ? "between " : "from ") << parameter.low
          << (parameter.open ? " and " : " to ") << parameter.high;
  } else if (below) {
    words << (parameter.open ? "above " : "at least ") << parameter.low;
  } else if (above) {
    words << (parameter.open ? "below " : "at most ") << parameter.high;
  } else {
    words << "any number";
  }
  return words.str();
}

std::string refusal_of(const RuleParameter& parameter, double value) {
  const bool inside = parameter.open ? value > parameter.low && value < parameter.high
                                     : value >= parameter.low && value <= parameter.high;
  const bool possible = parameter.off ? value == 0.0 || value == 1.0 : inside;
  if (std::isfinite(value) && possible) return {};
  std::ostringstream sentence;
  sentence << "'" << parameter.name << "' must be ";
  if (!std::isfinite(value)) {
    sentence << "a finite number";
  } else {
    sentence << range_words(parameter);
  }
  sentence << ", not " << value;
  return sentence.str();
}

}  // namespace stiction
