// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstring>
#include <type_traits>

#include "solver/lanes/in_registers.h"
#include "solver/lanes/lanes.h"

namespace stiction {

/// Four numbers, aligned as one is. (Said of an alias, not of its numbers: there, clang aligns it as
/// the vector.)
using FourNumbersAnywhere __attribute__((aligned(sizeof(Real)), may_alias)) = FourNumbers;
static_assert(alignof(FourNumbersAnywhere) == alignof(Real));

/// A vector of three numbers in one register of four; the fourth goes along, whatever it is. What it
/// gives has the bits of what Vec3 gives.
struct PackedVec3 {
  FourNumbers value;

  PackedVec3() = default;
  // Said for the reason that those of Lanes are.
  STICTION_LANES_INLINE PackedVec3(const PackedVec3& b) : value(b.value) {}
  STICTION_LANES_INLINE PackedVec3& operator=(const PackedVec3& b) {
    value = b.value;
    return *this;
  }
  STICTION_LANES_INLINE explicit PackedVec3(const FourNumbers& numbers) : value(numbers) {}
  // By halves in registers: of four numbers the compiler may make a record in memory, written in parts.
  STICTION_LANES_INLINE PackedVec3(const Vec3& v) {
    TwoNumbers xy;
    std::memcpy(&xy, v.data(), sizeof(xy));
    value = __builtin_shufflevector(xy, TwoNumbers{v.z(), 0}, 0, 1, 2, 3);
  }
  STICTION_LANES_INLINE static PackedVec3 Zero() { return PackedVec3(FourNumbers{}); }

  /// From and to a record of four, as one move: what is written in halves and read whole waits.
  STICTION_LANES_INLINE static PackedVec3 load(const void* record) {
    // By way of a value: a reference to what lies anywhere would be taken for one to aligned numbers.
    const FourNumbers numbers = *static_cast<const FourNumbersAnywhere*>(record);
    return PackedVec3(numbers);
  }
  STICTION_LANES_INLINE void store(void* record) const {
    *static_cast<FourNumbersAnywhere*>(record) = value;
  }

  STICTION_LANES_INLINE Real x() const { return value[0]; }
  STICTION_LANES_INLINE Real y() const { return value[1]; }
  STICTION_LANES_INLINE Real z() const { return value[2]; }
  /// The fourth in all places.
  STICTION_LANES_INLINE PackedVec3 fourths() const {
    return PackedVec3(__builtin_shufflevector(value, value, 3, 3, 3, 3));
  }
  STICTION_LANES_INLINE PackedVec3 with_fourth(const PackedVec3& of) const {
    return PackedVec3(__builtin_shufflevector(value, of.value, 0, 1, 2, 7));
  }

  /// With 0 for the fourth: by its bits, which takes one instruction where a shuffle takes three.
  STICTION_LANES_INLINE PackedVec3 without_fourth() const {
    using Bits = decltype(value < value);
    return PackedVec3(
        reinterpret_cast<FourNumbers>(reinterpret_cast<Bits>(value) & Bits{-1, -1, -1, 0}));
  }

  STICTION_LANES_INLINE friend PackedVec3 operator+(const PackedVec3& a, const PackedVec3& b) {
    return PackedVec3(a.value + b.value);
  }
  STICTION_LANES_INLINE friend PackedVec3 operator-(const PackedVec3& a, const PackedVec3& b) {
    return PackedVec3(a.value - b.value);
  }
  /// Number by number.
  STICTION_LANES_INLINE friend PackedVec3 operator*(const PackedVec3& a, const PackedVec3& b) {
    return PackedVec3(a.value * b.value);
  }
  STICTION_LANES_INLINE friend PackedVec3 operator*(Real s, const PackedVec3& a) {
    return PackedVec3(s * a.value);
  }
  STICTION_LANES_INLINE PackedVec3& operator+=(const PackedVec3& b) { return *this = *this + b; }
  STICTION_LANES_INLINE PackedVec3& operator-=(const PackedVec3& b) { return *this = *this - b; }
  STICTION_LANES_INLINE PackedVec3& operator*=(Real s) { return *this = s * *this; }

  STICTION_LANES_INLINE PackedVec3 cwiseAbs() const {
    return PackedVec3(value < FourNumbers{} ? -value : value);
  }
  /// Number by number as std::min and std::max: of what is no number, the first.
  STICTION_LANES_INLINE PackedVec3 cwiseMin(const PackedVec3& b) const {
    return PackedVec3(b.value < value ? b.value : value);
  }
  STICTION_LANES_INLINE PackedVec3 cwiseMax(const PackedVec3& b) const {
    return PackedVec3(value < b.value ? b.value : value);
  }

  /// Sums as Eigen does of three numbers: (x + y) + z in double precision, where two go in a
  /// register, else x + (y + z).
  STICTION_LANES_INLINE Real dot(const PackedVec3& b) const {
    const FourNumbers product = value * b.value;
    if constexpr (std::is_same_v<Real, double>) return (product[0] + product[1]) + product[2];
    return product[0] + (product[1] + product[2]);
  }
  STICTION_LANES_INLINE Real squaredNorm() const { return dot(*this); }
  STICTION_LANES_INLINE Real norm() const { return std::sqrt(squaredNorm()); }
};

/// A vector of one kind as one of the other.
template <class To>
STICTION_LANES_INLINE To vector_cast(const PackedVec3& v) {
  if constexpr (std::is_same_v<To, PackedVec3>) {
    return v;
  } else {
    return To(v.x(), v.y(), v.z());
  }
}
template <class To>
STICTION_LANES_INLINE To vector_cast(const Vec3& v) {
  return To(v);
}

}  // namespace stiction
