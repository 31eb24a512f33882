// SPDX-License-Identifier: BSD-3-Clause
#include "validation/engine/kit/rounding.h"

#include <cfenv>
#include <stdexcept>

namespace stiction::kit {

int rounding_mode(const std::string& word) {
  if (word == kNearest) return FE_TONEAREST;
  if (word == "upward") return FE_UPWARD;
  if (word == "downward") return FE_DOWNWARD;
  if (word == "toward-zero") return FE_TOWARDZERO;
  throw std::runtime_error(std::string("setting '") + kRounding +
                           "' must be nearest, upward, downward or toward-zero, not '" + word +
                           "'");
}

Rounds::Rounds(int mode) : before_(std::fegetround()) { std::fesetround(mode); }
Rounds::~Rounds() { std::fesetround(before_); }

}  // namespace stiction::kit
