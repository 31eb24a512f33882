// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

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

// What `polar_terms` asks of a number besides arithmetic; lanes.h has the same for two side by
// side.
inline Real zero_where(bool condition, Real x) { return condition ? 0 : x; }
inline bool all_zero(Real x) { return x == 0.0; }

/// FᵀF.
template <class Number>
[[gnu::always_inline]] inline Eigen::Matrix3<Number> gram(const Eigen::Matrix3<Number>& f) {
  const Number xx = f.col(0).dot(f.col(0)), xy = f.col(0).dot(f.col(1)),
               zx = f.col(2).dot(f.col(0));
  const Number yy = f.col(1).dot(f.col(1)), yz = f.col(1).dot(f.col(2)),
               zz = f.col(2).dot(f.col(2));
  Eigen::Matrix3<Number> c;
  c << xx, xy, zx, xy, yy, yz, zx, yz, zz;
  return c;
}

/// cof F = det(F) F⁻ᵀ, for singular F too.
template <class Number>
[[gnu::always_inline]] inline Eigen::Matrix3<Number> cofactor(const Eigen::Matrix3<Number>& f) {
  Eigen::Matrix3<Number> cofactor;
  cofactor.col(0) = f.col(1).cross(f.col(2));
  cofactor.col(1) = f.col(2).cross(f.col(0));
  cofactor.col(2) = f.col(0).cross(f.col(1));
  return cofactor;
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

///   φ = tr S is the largest root of  φ⁴ − 2I₁φ² − 8Jφ + I₁² − 4I₂ = 0,
///   R = [4(φ² + I₁)F − 8FFᵀF + 8φ cof F] / D,   D = 4(φ³ − I₁φ − 2J),
///
/// I₁, I₂ the first two invariants of c = FᵀF and j = det F. Newton from √(3I₁) ≥ φ falls
/// monotonically. Accurate to round-off for moderate stretches. Meaningless unless j > kFlattest.
template <class Number>
[[gnu::always_inline]] inline PolarTerms<Number> polar_terms(const Eigen::Matrix3<Number>& c,
                                                             Number j) {
  using std::sqrt;
  const Number i1 = c.trace();
  const Number i2 = c(0, 0) * c(1, 1) + c(1, 1) * c(2, 2) + c(2, 2) * c(0, 0) - c(0, 1) * c(0, 1) -
                    c(1, 2) * c(1, 2) - c(2, 0) * c(2, 0);
  const Number constant = i1 * i1 - 4 * i2;
  Number phi = sqrt(3 * i1);
  Number running = 1.0;  // 0 once the root is found
  for (int iteration = 0; iteration < 20; ++iteration) {
    const Number square = phi * phi;
    const Number value = square * (square - 2 * i1) - 8 * j * phi + constant;
    const Number slope = 4 * (phi * (square - i1) - 2 * j);
    const Number change = value / slope;
    phi -= running * change;
    running = zero_where(change < kNearRoot * phi, running);  // the next change is below round-off
    if (all_zero(running)) break;
  }
  const Number d = phi * (phi * phi - i1) - 2 * j;
  const Number inverse = 1 / d;
  return {phi, (phi * phi + i1) * inverse, -2 * inverse, 2 * phi * inverse};
}

/// Rotation of the polar decomposition, in closed form; a nearly flat or inverted element goes to
/// the singular values.
inline Mat3 polar_rotation(const Mat3& f) {
  const Mat3 c = gram(f), cof = cofactor(f);
  const Real j = f.col(0).dot(cof.col(0));
  if (!(j > kFlattest)) return polar_rotation_by_svd(f);
  const PolarTerms<Real> r = polar_terms(c, j);
  return r.f * f + r.gram * (f * c) + r.cofactor * cof;
}

}  // namespace stiction
