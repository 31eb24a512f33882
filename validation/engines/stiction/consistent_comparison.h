// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/mesh/mesh.h"
#include "validation/engine/settings.h"

namespace stiction {

/// How the solver's consistent depths of two bodies in each other differ from exact ones.
struct ConsistentComparison {
  int vertices = 0;              ///< of either body, exactly in or on the other
  int border = 0;                ///< of those: an edge leaves
  int inner = 0;                 ///< … by their neighbours
  int deepest = 0;               ///< highest level
  int lost = 0;                  ///< in one answer and not in the other
  int other_level = 0;           ///< of another level than the exact one
  double depth_error = 0.0;      ///< largest, m
  double direction_error = 0.0;  ///< largest, rad
  /// The same over what rounding can make of them (ConsistentDepth::moved and turned).
  double depth_excess = 0.0, direction_excess = 0.0;

  void add(const ConsistentComparison& other);
};

/// Asks the solver, set up by `settings` with depth=consistent, about `asked`, and exact arithmetic
/// about `exact`: the same two bodies, or bodies that are where rounding would put them, a few ulp
/// off. What lies on a surface may then be on either side of it: it may be lost, and what is below
/// it get its depth in another number of steps, but a depth all the same.
ConsistentComparison compare_consistent(const TetMesh& exact_a, const TetMesh& exact_b,
                                        const TetMesh& asked_a, const TetMesh& asked_b,
                                        const Settings& settings);

}  // namespace stiction
