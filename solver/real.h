// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <type_traits>

/// The scalar of all that a step reads and writes: double, or float where the whole solver and all
/// that includes its headers is compiled with -DSTICTION_REAL=float. A program has one only.
#ifndef STICTION_REAL
#define STICTION_REAL double
#endif

namespace stiction {

using Real = STICTION_REAL;
static_assert(std::is_same_v<Real, double> || std::is_same_v<Real, float>);

// Double they stay, whatever Real is:
//   times                a count × Δt has more digits than a float; so Δt itself, and what is planned
//                        over time (Motion, Gravity, Load), whose differences over a step would lose
//                        them all
//   what is described    meshes and materials: what a Scene is made of is reckoned in double and
//                        rounded once
//   sums for people      energies, momenta, centres of mass (observables.h)

using Vec3 = Eigen::Matrix<Real, 3, 1>;
using Vec4 = Eigen::Matrix<Real, 4, 1>;
using Mat3 = Eigen::Matrix<Real, 3, 3>;
using Box3 = Eigen::AlignedBox<Real, 3>;

/// A multiple of the round-off of Real, given as what it is in double precision: 2²⁹ times as much in
/// single.
constexpr Real round_off(double in_double) {
  return static_cast<Real>(in_double * (static_cast<double>(std::numeric_limits<Real>::epsilon()) /
                                        std::numeric_limits<double>::epsilon()));
}

/// A threshold between round-off and what is measured. Single precision leaves less room between
/// the two, so that it needs a choice of its own.
constexpr Real by_precision(double in_double, double in_single) {
  return static_cast<Real>(std::is_same_v<Real, double> ? in_double : in_single);
}

}  // namespace stiction
