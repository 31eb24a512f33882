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
[[gnu::noinline]] inline Mat3 polar_rotation_by_svd(const Mat3& f) {
  const Eigen::JacobiSVD<Mat3> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0.0) u.col(2) = -u.col(2);
  return u * svd.matrixV().transpose();
}

// What `polar_terms` asks of a number besides arithmetic; lanes.h has the same for two side by
// side.
inline double zero_where(bool condition, double x) { return condition ? 0.0 : x; }
inline bool all_zero(double x) { return x == 0.0; }

/// FᵀF.
template <class Real>
[[gnu::always_inline]] inline Eigen::Matrix3<Real> gram(const Eigen::Matrix3<Real>& f) {
  const Real xx = f.col(0).dot(f.col(0)), xy = f.col(0).dot(f.col(1)), zx = f.col(2).dot(f.col(0));
  const Real yy = f.col(1).dot(f.col(1)), yz = f.col(1).dot(f.col(2)), zz = f.col(2).dot(f.col(2));
  Eigen::Matrix3<Real> c;
  c << xx, xy, zx, xy, yy, yz, zx, yz, zz;
  return c;
}

/// cof F = det(F) F⁻ᵀ, for singular F too.
template <class Real>
[[gnu::always_inline]] inline Eigen::Matrix3<Real> cofactor(const Eigen::Matrix3<Real>& f) {
  Eigen::Matrix3<Real> cofactor;
  cofactor.col(0) = f.col(1).cross(f.col(2));
  cofactor.col(1) = f.col(2).cross(f.col(0));
  cofactor.col(2) = f.col(0).cross(f.col(1));
  return cofactor;
}

/// The polar decomposition F = R S in closed form: tr S, and R = f F + gram F FᵀF + cofactor cof F.
template <class Real>
struct PolarTerms {
  Real stretch;  ///< tr S
  Real f, gram, cofactor;
};

/// Below this det F, 1 % of the undeformed volume, the closed form loses digits.
inline constexpr double kFlattest = 0.01;

///   φ = tr S is the largest root of  φ⁴ − 2I₁φ² − 8Jφ + I₁² − 4I₂ = 0,
///   R = [4(φ² + I₁)F − 8FFᵀF + 8φ cof F] / D,   D = 4(φ³ − I₁φ − 2J),
///
/// I₁, I₂ the first two invariants of c = FᵀF and j = det F. Newton from √(3I₁) ≥ φ falls
/// monotonically. Accurate to round-off for moderate stretches. Meaningless unless j > kFlattest.
template <class Real>
[[gnu::always_inline]] inline PolarTerms<Real> polar_terms(const Eigen::Matrix3<Real>& c, Real j) {
  using std::sqrt;
  const Real i1 = c.trace();
  const Real i2 = c(0, 0) * c(1, 1) + c(1, 1) * c(2, 2) + c(2, 2) * c(0, 0) - c(0, 1) * c(0, 1) -
                  c(1, 2) * c(1, 2) - c(2, 0) * c(2, 0);
  const Real constant = i1 * i1 - 4.0 * i2;
  Real phi = sqrt(3.0 * i1);
  Real running = 1.0;  // 0 once the root is found
  for (int iteration = 0; iteration < 20; ++iteration) {
    const Real square = phi * phi;
    const Real value = square * (square - 2.0 * i1) - 8.0 * j * phi + constant;
    const Real slope = 4.0 * (phi * (square - i1) - 2.0 * j);
    const Real change = value / slope;
    phi -= running * change;
    running = zero_where(change < 1e-9 * phi, running);  // the next change is below round-off
    if (all_zero(running)) break;
  }
  const Real d = phi * (phi * phi - i1) - 2.0 * j;
  const Real inverse = 1.0 / d;
  return {phi, (phi * phi + i1) * inverse, -2.0 * inverse, 2.0 * phi * inverse};
}

/// Rotation of the polar decomposition, in closed form; a nearly flat or inverted element goes to
/// the singular values.
inline Mat3 polar_rotation(const Mat3& f) {
  const Mat3 c = gram(f), cof = cofactor(f);
  const double j = f.col(0).dot(cof.col(0));
  if (!(j > kFlattest)) return polar_rotation_by_svd(f);
  const PolarTerms<double> r = polar_terms(c, j);
  return r.f * f + r.gram * (f * c) + r.cofactor * cof;
}

}  // namespace stiction
