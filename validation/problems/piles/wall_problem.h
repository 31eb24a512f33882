// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "validation/engine/problem.h"

namespace stiction {

/// Equal boxes piled on level ground, exactly on each other: a wall in running bond (every other
/// course begins and ends with half a brick), or a stack. Gravity grows until `full`, so that
/// nothing bounces.
struct WallSetup {
  int courses = 5;
  int bricks = 5;           ///< in a course without halves; 1: a stack, in which no course has any
  double edge = 0.2;        ///< of a brick, a cube, m
  double joint = 1e-3;      ///< between neighbours of a course, which don't touch, m
  double friction = 0.5;    ///< μ of all contacts
  double density = 1000.0;  ///< ρ, kg/m³
  double drag_ends = 0.0;   ///< 0.2 s after a medium fades, in which a wall settles, s; 0: none
  double full = 0.5;        ///< s
  /// Without lateral strain the pile is its closed form's column.
  Elasticity elasticity{.youngs_modulus = 2e7, .poisson_ratio = 0.0, .damping_time = 5e-4};
};

/// Bodies: course after course from the ground up, each along x.
Problem wall_problem(const WallSetup& setup);

/// Those of the topmost course.
std::vector<std::size_t> top_course(const WallSetup& setup);

/// How far the centres of the topmost course come down, m. Rigid bricks: 0; elastic ones
///
///   ρ g/E · (H z − ½(z² + h²/12)),   H = n h,  z = H − h/2: the mean over a brick of height h
///
/// and h²/12 (1 + 2/c²) for c > 0 `cells` along it, whose vertices carry its mass;
/// since σ(z) = ρ g (H − z) everywhere: half a brick presses with half a brick's weight.
double elastic_fall(const WallSetup& setup, int cells);

}  // namespace stiction
