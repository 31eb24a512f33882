// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "validation/engine/engine.h"
#include "validation/engine/problem.h"

namespace stiction {

/// What of the cube comes first.
enum class Stance { kFace, kEdge, kCorner };

/// A soft cube thrown at the middle of a thin sheet, without gravity. The sheet has a frame below
/// its rim, as a drum has, and the frame's lower face is held.
struct SheetSetup {
  double thickness = 5e-3;  ///< of the sheet, m
  double speed = 10.0;      ///< of the cube, m/s
  Stance stance = Stance::kFace;
  bool backed = false;    ///< the sheet's whole lower face is held too
  double width = 0.4;     ///< of the sheet, its rim included, m
  int cells = 8;          ///< along the sheet's width; the rim is one wide
  double frame = 0.05;    ///< height of the frame, m
  double edge = 0.1;      ///< of the cube, m
  double gap = 5e-3;      ///< between cube and sheet at the start, m
  double friction = 0.5;  ///< μ
  Elasticity cube{.youngs_modulus = 2e5, .poisson_ratio = 0.3, .damping_time = 2e-3};
  Elasticity sheet{.youngs_modulus = 2e5, .poisson_ratio = 0.3, .damping_time = 2e-5};
};

/// Bodies: cube (0), sheet (1), its lower face at z = 0 in the middle.
Problem sheet_problem(const SheetSetup& setup);

/// Whether the cube's centre is on the far side of the sheet: below every vertex of the part of it
/// that isn't held, or below a triangle of it that lies right above or beneath.
bool has_passed(const Engine& engine, const SheetSetup& setup);

}  // namespace stiction
