// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Gmpq.h>

#include <Eigen/Core>
#include <array>

namespace stiction::reference {

/// A fraction of whole numbers of any length, in which nothing is rounded; each double is one.
using Exact = CGAL::Gmpq;
using ExactVector = std::array<Exact, 3>;

inline ExactVector exact(const Eigen::Vector3d& v) {
  return {Exact(v.x()), Exact(v.y()), Exact(v.z())};
}

inline Exact dot(const ExactVector& a, const ExactVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace stiction::reference
