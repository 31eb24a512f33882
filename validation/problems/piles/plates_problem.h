// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/problem.h"

namespace stiction {

/// A plate on a larger one that is held below, for what contacts cost: as many as one likes, on
/// both sides.
struct PlatesSetup {
  int cells = 10;          ///< along the upper plate; (cells + 1)² of its vertices touch
  double tan_slope = 0.0;  ///< tan θ: gravity is turned towards x
  Elasticity elasticity{.youngs_modulus = 2e5, .poisson_ratio = 0.3, .damping_time = 1e-3};
  double density = 1000.0;  ///< kg/m³
};

inline constexpr double kPlateCell = 0.05;  ///< of both meshes, and either plate's thickness, m

/// Bodies: the upper plate (0) and the lower one (1), turned against each other so that the two
/// meshes nowhere match: nearly all vertices of the upper one touch, and as many of the lower one.
Problem plates_problem(const PlatesSetup& setup);

}  // namespace stiction
