// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/lanes/lanes.h"

namespace stiction {

/// Vectors and matrices of lanes. A sum of three is a + (b + c), at each width.
template <class Number>
struct LaneVector {
  Number x, y, z;

  STICTION_LANES_INLINE friend LaneVector operator+(const LaneVector& a, const LaneVector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  STICTION_LANES_INLINE friend LaneVector operator-(const LaneVector& a, const LaneVector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  STICTION_LANES_INLINE friend LaneVector operator-(const LaneVector& a) {
    return {-a.x, -a.y, -a.z};
  }
  STICTION_LANES_INLINE friend LaneVector operator*(const Number& s, const LaneVector& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
  STICTION_LANES_INLINE friend LaneVector operator/(const LaneVector& a, const Number& s) {
    return {a.x / s, a.y / s, a.z / s};
  }
};

template <class Number>
STICTION_LANES_INLINE Number dot(const LaneVector<Number>& a, const LaneVector<Number>& b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}

template <class Number>
STICTION_LANES_INLINE LaneVector<Number> cross(const LaneVector<Number>& a,
                                               const LaneVector<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Three columns.
template <class Number>
struct LaneMatrix {
  LaneVector<Number> column[3];

  /// Columns combined: this times a vector.
  STICTION_LANES_INLINE friend LaneVector<Number> operator*(const LaneMatrix& a,
                                                            const LaneVector<Number>& b) {
    return b.x * a.column[0] + (b.y * a.column[1] + b.z * a.column[2]);
  }
  STICTION_LANES_INLINE friend LaneMatrix operator*(const LaneMatrix& a, const LaneMatrix& b) {
    return {{a * b.column[0], a * b.column[1], a * b.column[2]}};
  }
  STICTION_LANES_INLINE LaneMatrix transpose() const {
    const auto& [a, b, c] = column;
    return {{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}}};
  }
};

/// A symmetric one.
template <class Number>
struct LaneSymmetric {
  Number xx, yy, zz, xy, yz, zx;

  STICTION_LANES_INLINE Number trace() const { return xx + (yy + zz); }
  STICTION_LANES_INLINE LaneMatrix<Number> whole() const {
    return {{{xx, xy, zx}, {xy, yy, yz}, {zx, yz, zz}}};
  }
  STICTION_LANES_INLINE void add_to_diagonal(const Number& a) {
    xx += a;
    yy += a;
    zz += a;
  }
  STICTION_LANES_INLINE friend LaneSymmetric operator+(const LaneSymmetric& a,
                                                       const LaneSymmetric& b) {
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.yz + b.yz, a.zx + b.zx};
  }
  STICTION_LANES_INLINE friend LaneSymmetric operator*(const Number& s, const LaneSymmetric& a) {
    return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.zx};
  }
};

/// `yes` where it holds, else `no`.
template <int Bytes>
STICTION_LANES_INLINE LaneSymmetric<Lanes<Bytes>> choose_all(
    const typename Lanes<Bytes>::Mask& where, const LaneSymmetric<Lanes<Bytes>>& yes,
    const LaneSymmetric<Lanes<Bytes>>& no) {
  return {choose(where, yes.xx, no.xx), choose(where, yes.yy, no.yy), choose(where, yes.zz, no.zz),
          choose(where, yes.xy, no.xy), choose(where, yes.yz, no.yz), choose(where, yes.zx, no.zx)};
}

/// AᵀA.
template <class Number>
STICTION_LANES_INLINE LaneSymmetric<Number> gram(const LaneMatrix<Number>& a) {
  const auto& [x, y, z] = a.column;
  return {dot(x, x), dot(y, y), dot(z, z), dot(x, y), dot(y, z), dot(z, x)};
}

/// ½ (AᵀB + BᵀA).
template <class Number>
STICTION_LANES_INLINE LaneSymmetric<Number> symmetric_product(const LaneMatrix<Number>& a,
                                                              const LaneMatrix<Number>& b) {
  const auto& [ax, ay, az] = a.column;
  const auto& [bx, by, bz] = b.column;
  const Number half(Real(0.5));
  return {dot(ax, bx),
          dot(ay, by),
          dot(az, bz),
          half * (dot(ax, by) + dot(ay, bx)),
          half * (dot(ay, bz) + dot(az, by)),
          half * (dot(az, bx) + dot(ax, bz))};
}

/// cof A = det(A) A⁻ᵀ, for singular A too.
template <class Number>
STICTION_LANES_INLINE LaneMatrix<Number> cofactor(const LaneMatrix<Number>& a) {
  const auto& [x, y, z] = a.column;
  return {{cross(y, z), cross(z, x), cross(x, y)}};
}

/// One lane's matrix.
template <int Bytes>
Mat3 one_of(const LaneMatrix<Lanes<Bytes>>& lanes, int lane) {
  const auto& [a, b, c] = lanes.column;
  Mat3 one;
  one << a.x[lane], b.x[lane], c.x[lane], a.y[lane], b.y[lane], c.y[lane], a.z[lane], b.z[lane],
      c.z[lane];
  return one;
}
inline Mat3 one_of(const LaneMatrix<Real>& m) {
  const auto& [a, b, c] = m.column;
  Mat3 one;
  one << a.x, b.x, c.x, a.y, b.y, c.y, a.z, b.z, c.z;
  return one;
}

}  // namespace stiction
