// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "solver/real.h"

namespace stiction {

/// As many numbers as one register of 16 bytes holds, two in double precision and four in single,
/// that go through the same operations side by side: a scalar for Eigen's matrices, so that one
/// formula handles as many elements.
struct Lanes {
  static constexpr int kCount = 16 / sizeof(Real);
  using Register = Real __attribute__((vector_size(16)));

  Register value;

  Lanes() = default;
  Lanes(Real all) {
    for (int lane = 0; lane < kCount; ++lane) value[lane] = all;
  }
  explicit Lanes(Register register_value) : value(register_value) {}

  Real operator[](int lane) const { return value[lane]; }

  Lanes& operator+=(Lanes b) { return *this = Lanes(value + b.value); }
  Lanes& operator-=(Lanes b) { return *this = Lanes(value - b.value); }
  Lanes& operator*=(Lanes b) { return *this = Lanes(value * b.value); }
  friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.value + b.value); }
  friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.value - b.value); }
  friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.value * b.value); }
  friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.value / b.value); }
  friend Lanes operator-(Lanes a) { return Lanes(-a.value); }
  friend auto operator<(Lanes a, Lanes b) { return a.value < b.value; }
  friend Lanes zero_where(decltype(Register{} < Register{}) condition, Lanes a) {
    return Lanes(condition ? Register{} : a.value);
  }
  friend bool all_zero(Lanes a) {
    for (int lane = 0; lane < kCount; ++lane) {
      if (a[lane] != 0) return false;
    }
    return true;
  }
  friend Lanes sqrt(Lanes a) {
    for (int lane = 0; lane < kCount; ++lane) a.value[lane] = std::sqrt(a.value[lane]);
    return a;
  }
};

}  // namespace stiction

template <>
struct Eigen::NumTraits<stiction::Lanes> : Eigen::GenericNumTraits<stiction::Lanes> {
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};
