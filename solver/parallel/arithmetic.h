// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef __x86_64__
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace stiction {

/// How a thread does arithmetic, its rounding mode and the like; and which exceptions arithmetic has
/// raised in it.
#ifdef __x86_64__
// Of the unit that all numbers here go through. <cfenv> looks after another unit too, which took a quarter
// of a microsecond at either end of a work (measured).
class Arithmetic {
 public:
  static Arithmetic of_this_thread() { return Arithmetic(_mm_getcsr() & ~kRaised); }
  void apply() const { _mm_setcsr(value_); }  // nothing has been raised
  static int raised() { return static_cast<int>(_mm_getcsr() & kRaised); }
  static void raise(int which) { _mm_setcsr(_mm_getcsr() | static_cast<unsigned>(which)); }

 private:
  static constexpr unsigned kRaised = _MM_EXCEPT_MASK;
  explicit Arithmetic(unsigned value) : value_(value) {}
  unsigned value_;
};
#else
class Arithmetic {
 public:
  static Arithmetic of_this_thread() {
    Arithmetic arithmetic;
    std::fegetenv(&arithmetic.value_);
    return arithmetic;
  }
  void apply() const {
    std::fesetenv(&value_);
    std::feclearexcept(FE_ALL_EXCEPT);
  }
  static int raised() { return std::fetestexcept(FE_ALL_EXCEPT); }
  static void raise(int which) { std::feraiseexcept(which); }

 private:
  std::fenv_t value_;
};
#endif

}  // namespace stiction
