// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Core>

#include "reference/exact/fractions.h"

namespace stiction::reference {

/// Decides exactly what lies where, and computes what it makes in doubles.
using FilteredKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
inline FilteredKernel::Point_3 filtered(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

/// Computes in fractions, without round-off.
using RationalKernel = CGAL::Simple_cartesian<Exact>;
inline RationalKernel::Point_3 rational(const Eigen::Vector3d& x) {
  return {Exact(x.x()), Exact(x.y()), Exact(x.z())};
}

}  // namespace stiction::reference
