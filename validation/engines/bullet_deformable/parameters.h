// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/kit/stiction_engine.h"

namespace stiction::bullet_deformable {

/// Bullet's own dials, as resolved for one run; reading them writes them into the record.
struct Parameters {
  double time_step;       ///< Δt, s
  bool implicit;          ///< elasticity by Newton's method; else explicit, but for damping
  bool line_search;       ///< of Newton's method
  bool projection;        ///< contacts by projected conjugate gradients; else by multipliers
  bool neo_hookean;       ///< else corotated linear elasticity
  int iterations;         ///< of the contacts, per step
  double residual;        ///< m²/s²: contacts are solved when their largest is below
  double erp;             ///< share of a penetration that a step takes back
  double max_correction;  ///< m/s, of that
  double mass_damping;    ///< α, 1/s: force −α m v
  double margin;          ///< m, around the bodies' nodes
  double ground_size;     ///< edge of the box that stands for a half-space, m
  double voxel;           ///< of the distance field about it, m
  int cells;              ///< along a box's longest edge
  int ball_cells;         ///< along the diameter of a ball
};

/// Reads the settings; refuses in words what they cannot be.
Parameters read_parameters(const stiction_problem& problem);

/// What read_parameters knows, with an entry without a name at its end.
extern const stiction_setting kSettings[];

}  // namespace stiction::bullet_deformable
