// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace stiction {

/// Two numbers that go through the same operations side by side, in one register: a scalar for
/// Eigen's matrices, so that one formula handles two elements.
struct Lanes {
  using Register = double __attribute__((vector_size(2 * sizeof(double))));

  Register value;

  Lanes() = default;
  Lanes(double both) : value{both, both} {}
  Lanes(double first, double second) : value{first, second} {}
  explicit Lanes(Register register_value) : value(register_value) {}

  double operator[](int lane) const { return value[lane]; }

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
  friend bool all_zero(Lanes a) { return a[0] == 0.0 && a[1] == 0.0; }
  friend Lanes sqrt(Lanes a) { return {std::sqrt(a[0]), std::sqrt(a[1])}; }
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
