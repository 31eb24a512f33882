// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

#include "solver/scene.h"

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

/// Rotation of the polar decomposition F = R S in closed form.
///
///   φ = tr S is the largest root of  φ⁴ − 2I₁φ² − 8Jφ + I₁² − 4I₂ = 0,
///   R = [4(φ² + I₁)F − 8FFᵀF + 8φ cof F] / D,   D = 4(φ³ − I₁φ − 2J),
///
/// I₁, I₂ the first two invariants of FᵀF and J = det F. Newton from √(3I₁) ≥ φ falls
/// monotonically. Accurate to round-off for moderate stretches; a nearly flat or inverted element
/// (J below 1 % of the undeformed one) goes to the singular values.
[[gnu::always_inline]] inline Mat3 polar_rotation(const Mat3& f) {
  const Mat3 c = f.transpose() * f;
  const double i1 = c.trace();
  const double i2 = c(0, 0) * c(1, 1) + c(1, 1) * c(2, 2) + c(2, 2) * c(0, 0) - c(0, 1) * c(0, 1) -
                    c(1, 2) * c(1, 2) - c(2, 0) * c(2, 0);
  Mat3 cofactor;
  cofactor.col(0) = f.col(1).cross(f.col(2));
  cofactor.col(1) = f.col(2).cross(f.col(0));
  cofactor.col(2) = f.col(0).cross(f.col(1));
  const double j = f.col(0).dot(cofactor.col(0));
  if (!(j > 0.01)) return polar_rotation_by_svd(f);

  double phi = std::sqrt(3.0 * i1);
  for (int iteration = 0; iteration < 20; ++iteration) {
    const double square = phi * phi;
    const double value = square * (square - 2.0 * i1) - 8.0 * j * phi + i1 * i1 - 4.0 * i2;
    const double slope = 4.0 * (phi * (square - i1) - 2.0 * j);
    const double change = value / slope;
    phi -= change;
    if (std::abs(change) < 1e-9 * phi) break;  // the next change would be below round-off
  }
  const double d = 4.0 * (phi * (phi * phi - i1) - 2.0 * j);
  return (4.0 * (phi * phi + i1) * f - 8.0 * f * c + 8.0 * phi * cofactor) / d;
}

}  // namespace stiction
