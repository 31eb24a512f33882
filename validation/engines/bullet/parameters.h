// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "validation/engine/kit/stiction_engine.h"

namespace stiction::bullet {

/// Bullet's own dials, as resolved for one run; reading them writes them into the record.
struct Parameters {
  double time_step;         ///< Δt, s
  int iterations;           ///< of the solver, per step
  std::string solver;       ///< sequential_impulse, nncg, dantzig or projected_gauss_seidel
  double erp;               ///< share of a penetration that a step takes back
  double friction_erp;      ///< the same of a slipped friction anchor
  double cfm;               ///< softness of all contacts, 1/kg s
  double split_threshold;   ///< m, < 0: deeper penetrations are corrected apart from velocities
  double warm_start;        ///< share of the last impulses to begin with; 0: none
  int friction_directions;  ///< 1, or 2 (a pyramid)
  bool
      directions_along_slip;  ///< the first friction direction is that of the slip, while there is any
  bool random_order;          ///< of the constraints, anew each iteration
  bool friction_anchors;      ///< contacts remember where they stuck
  bool interleaved;           ///< a contact's friction is solved next to its normal row
  bool ground_is_box;         ///< half-spaces are big boxes; else infinite planes
  double ground_size;         ///< edge of such a box, m
  int plane_points;         ///< tilted queries of a plane for more contacts at once; 0: one a step
  double contact_breaking;  ///< m: so far apart a contact is dropped, and before it is made
  double hull_margin;       ///< m, around convex meshes; boxes and balls have the size given
};

/// Reads the settings; refuses in words what they cannot be.
Parameters read_parameters(const stiction_problem& problem);

/// What read_parameters knows, with an entry without a name at its end.
extern const stiction_setting kSettings[];

}  // namespace stiction::bullet
