// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/kit/stiction_engine.h"

namespace stiction::ode {

/// Where a contact's first friction direction points; the second is normal to it.
enum class FrictionDirection {
  kEngine,     ///< ODE's own: axes of the world's, projected into the plane of contact
  kSlip,       ///< along the slip at the step's start
  kPredicted,  ///< along what the slip would be at the step's end without contact
};

/// ODE's own dials, as resolved for one run; reading them writes them into the record.
struct Parameters {
  double time_step;                ///< Δt, s
  bool exact;                      ///< dWorldStep (Dantzig); else dWorldQuickStep
  int iterations;                  ///< of the quick step
  double over_relaxation;          ///< of the quick step
  double erp;                      ///< share of an error that a step takes back
  double cfm;                      ///< softness of all constraints, m/(N s)
  double soft_cfm;                 ///< that of contact normals; < 0: as `cfm`
  double max_correcting_velocity;  ///< m/s, of contacts; 0: no bound
  double surface_layer;            ///< m: contacts sink in so far before they are pushed out
  int max_contacts;                ///< of a pair
  FrictionDirection friction_direction;
  double linear_damping, angular_damping;  ///< share of a velocity lost in a step
  bool finite_rotation;                    ///< rotations are integrated as such
};

/// Reads the settings; refuses in words what they cannot be.
Parameters read_parameters(const stiction_problem& problem);

/// What read_parameters knows, with an entry without a name at its end.
extern const stiction_setting kSettings[];

}  // namespace stiction::ode
