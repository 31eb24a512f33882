// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>
#include <string>

namespace stiction {

/// Whether this thread's arithmetic, while it lives, does what has no number for an answer: an invalid
/// operation (0/0, ∞ − ∞, √−1), a division by zero, an overflow. What a program of its own reckons is
/// not seen.
class ArithmeticWatch {
 public:
  ArithmeticWatch();
  ~ArithmeticWatch();  ///< flags that were up before are up again
  ArithmeticWatch(const ArithmeticWatch&) = delete;
  ArithmeticWatch& operator=(const ArithmeticWatch&) = delete;

  /// "division by zero, overflow"; empty: nothing.
  std::string found() const;

 private:
  std::fexcept_t before_{};
};

}  // namespace stiction
