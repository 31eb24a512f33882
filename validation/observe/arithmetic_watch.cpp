// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/observe/arithmetic_watch.h"

#include <utility>

namespace stiction {

namespace {

constexpr int kFaults = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

}  // namespace

ArithmeticWatch::ArithmeticWatch() {
  std::fegetexceptflag(&before_, kFaults);
  std::feclearexcept(kFaults);
}

ArithmeticWatch::~ArithmeticWatch() { std::fesetexceptflag(&before_, kFaults); }

std::string ArithmeticWatch::found() const {
  std::string words;
  for (const auto& [flag, name] : {std::pair{FE_INVALID, "an invalid operation"},
                                   {FE_DIVBYZERO, "a division by zero"},
                                   {FE_OVERFLOW, "an overflow"}}) {
    if (std::fetestexcept(flag) == 0) continue;
    words += (words.empty() ? "" : ", ") + std::string(name);
  }
  return words;
}

}  // namespace stiction
