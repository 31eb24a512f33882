// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/limit/limit_analysis.h"
#include "validation/core/case_run.h"
#include "validation/engine/problem.h"

namespace stiction {

/// Rows of n, n − 1, …, 1 cubic boxes on a slope that falls along x; the slope is gravity's
/// direction, so that the ground stays level in coordinates. Neighbours of a row stand `gap` apart:
/// under the load's weight a box widens by less than a tenth of it, so that they never touch.
struct PyramidSetup {
  int rows = 3;
  double width = 0.1;         ///< edge of a box, m
  double gap = 5e-3;          ///< m
  double box_mass = 1.0;      ///< kg
  int cells = 1;              ///< of a box's mesh along an edge; the slab's cells are as large
  bool rigid_ground = false;  ///< a half-space instead of a deformable slab
  double slab_height = 0.1;   ///< m; its lower face is held
  double tan_slope = 0.2;     ///< tan θ
  double friction = 0.3;      ///< μ of all contacts
  Elasticity elasticity{.youngs_modulus = 5e5, .poisson_ratio = 0.3, .damping_time = 6e-3};
  bool flush = false;    ///< no row is shifted across the slope: edges lie on edges
  double settled = 6.0;  ///< time at which its rocking has died out, s
};

/// Gravity grows into the slope until `kPressed`, then along it from `kTilts` to `kTilted`, s.
inline constexpr double kPressed = 0.4, kTilts = 0.6, kTilted = 1.0;

int box_count(const PyramidSetup& setup);

/// Bodies: the boxes from the lowest row up, from left (uphill) to right; then the slab.
Problem pyramid_problem(const PyramidSetup& setup);

/// Exact critical tan θ of the rigid pyramid, by limit analysis.
reference::LimitBracket pyramid_limit(const PyramidSetup& setup);

}  // namespace stiction
