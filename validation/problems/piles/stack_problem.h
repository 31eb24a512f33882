// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "validation/engine/problem.h"

namespace stiction {

/// What a stack stands on.
enum class Ground {
  kRigid,  ///< a half-space
  kSlab,  ///< a deformable slab three times as wide and as high, its lower face held; a thinner one
          ///< would make the step smaller
  kFlush  ///< a deformable block exactly as wide as the stack, its lower face held
};
std::string word(Ground ground);

/// Boxes exactly on each other, vertex on vertex and edge on edge, on a slope that falls along x.
/// The slope is gravity's direction, so that the ground stays level in coordinates.
struct StackSetup {
  int boxes = 5;
  Vec3 size{0.1, 0.1, 0.1};  ///< of a box, m
  int cells = 1;             ///< of a box's mesh along x; the ground's cells are as large
  Ground ground = Ground::kRigid;
  double tan_slope = 0.0;       ///< tan θ
  double friction = 0.5;        ///< μ of all contacts
  double density = 1000.0;      ///< kg/m³, of all but the top
  double top_density = 1.0;     ///< of the topmost box, in terms of the others'
  std::vector<double> turns{};  ///< of each box about the vertical, rad; empty: none
  /// β · E = 1000 Pa s: between what the box on the slab (400) and the pyramid (3000) have.
  Elasticity elasticity{.youngs_modulus = 1e7, .poisson_ratio = 0.3, .damping_time = 1e-4};
};

/// A tall stack sways at 10 rad/s, which strain-rate damping would take minutes to end. So it
/// settles in a medium that damps its slowest motion nearly critically, and which is gone before
/// rest is judged: what moves then is the contact's doing.
///
///   ω = 3.516 √(E a²/(12 ρ))/L²,  the first bending of a clamped column of width a, height L
///   c = 1.5 ω: it falls by e^{−c t/2}, nineteen decades in 6 s for ten cubes
Drag settling_drag(const StackSetup& setup);
inline constexpr double kStackSettled = 9.0;  ///< s: the medium is gone since 1 s

/// Gravity grows into the slope until `kStackPressed`, then along it until `kStackTilted`, s.
inline constexpr double kStackPressed = 0.4, kStackTilts = 0.6, kStackTilted = 1.6;

/// Bodies: the boxes from the lowest up; then what they stand on, if it deforms.
Problem stack_problem(const StackSetup& setup);

/// The steepest tan θ at which the stack stands. The boxes' turns are left out.
struct StackLimit {
  double rigid = 0.0;    ///< neither slides nor topples at any joint: proved by limit analysis
  double elastic = 0.0;  ///< nor topples by its lean: the column without tension; ≤ rigid
};
StackLimit critical_tan(const StackSetup& setup);

/// "7 boxes at 2.0°, 1 cells, slab".
std::string stack_words(const StackSetup& setup);

}  // namespace stiction
