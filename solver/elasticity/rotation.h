// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

#include "solver/lanes/lane_matrix.h"
#include "solver/scene/scene.h"

namespace stiction {

/// Rotation of the polar decomposition F = R S by singular values; works for every F, inverted ones
/// included (the smallest singular value takes the sign of det F). The slow twin of
/// `polar_rotation`.
template <class Number>
[[gnu::noinline]] Eigen::Matrix3<Number> polar_rotation_by_svd(const Eigen::Matrix3<Number>& f) {
  const Eigen::JacobiSVD<Eigen::Matrix3<Number>> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3<Number> u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) = -u.col(2);
  return u * svd.matrixV().transpose();
}

/// The polar decomposition F = R S in closed form: tr S, and R = f F + gram F FᵀF + cofactor cof F.
template <class Number>
struct PolarTerms {
  Number stretch;  ///< tr S
  Number f, gram, cofactor;
};

/// Of φ: a change of Newton's iteration whose square is below round-off.
inline constexpr Real kNearRoot = by_precision(1e-9, 1e-4);

/// Below this det F, 1 % of the undeformed volume, the closed form loses digits.
inline constexpr Real kFlattest = 0.01;

/// The root that gives the rotation, and Newton's way to it:
///
///   φ = tr S is the largest root of  φ⁴ − 2I₁φ² − 8Jφ + I₁² − 4I₂ = 0,
///   R = [4(φ² + I₁)F − 8FFᵀF + 8φ cof F] / D,   D = 4(φ³ − I₁φ − 2J),
///
/// I₁, I₂ the first two invariants of FᵀF and J = det F. Newton from √(3I₁) ≥ φ falls monotonically.
/// Accurate to round-off for moderate stretches. Meaningless unless J > kFlattest. A number, or
/// lanes of which each goes on until it is there.
template <class Number>
struct StretchRoot {
  static constexpr int kMostSteps = 20;

  Number i1, j, constant, phi, running;  // running: 0 once the root is found

  StretchRoot() = default;
  /// Of FᵀF and det F.
  STICTION_LANES_INLINE StretchRoot(const LaneSymmetric<Number>& c, const Number& det)
      : i1(c.trace()), j(det), running(Real(1)) {
    using std::sqrt;
    const Number i2 =
        c.xx * c.yy + c.yy * c.zz + c.zz * c.xx - c.xy * c.xy - c.yz * c.yz - c.zx * c.zx;
    constant = i1 * i1 - Real(4) * i2;
    phi = sqrt(Real(3) * i1);
  }

  STICTION_LANES_INLINE bool found() const { return all_zero(running); }

  STICTION_LANES_INLINE void improve() {
    const Number square = phi * phi;
    const Number value = square * (square - Real(2) * i1) - Real(8) * j * phi + constant;
    const Number slope = Real(4) * (phi * (square - i1) - Real(2) * j);
    const Number change = value / slope;
    phi -= running * change;
    // The next change is below round-off.
    running = choose_below(change, kNearRoot * phi, Number(Real(0)), running);
  }

  STICTION_LANES_INLINE PolarTerms<Number> terms() const {
    const Number inverse = Real(1) / (phi * (phi * phi - i1) - Real(2) * j);
    return {phi, (phi * phi + i1) * inverse, Real(-2) * inverse, Real(2) * phi * inverse};
  }
};

/// Rotation of the polar decomposition, in closed form; a nearly flat or inverted element goes to
/// the singular values.
inline Mat3 polar_rotation(const Mat3& f) {
  const auto x = f.col(0), y = f.col(1), z = f.col(2);
  const LaneSymmetric<Real> c = {x.dot(x), y.dot(y), z.dot(z), x.dot(y), y.dot(z), z.dot(x)};
  Mat3 cof;
  cof << y.cross(z), z.cross(x), x.cross(y);
  const Real j = x.dot(cof.col(0));
  if (!(j > kFlattest)) return polar_rotation_by_svd(f);
  StretchRoot<Real> root(c, j);
  for (int k = 0; k < root.kMostSteps && !root.found(); ++k) root.improve();
  const PolarTerms<Real> r = root.terms();
  return r.f * f + r.gram * (f * one_of(c.whole())) + r.cofactor * cof;
}

}  // namespace stiction
