// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/engine.h"
#include "validation/engine/problem.h"

namespace stiction {

/// Factor by which a small disturbance of a scene at rest falls in a step, once only its slowest
/// part is left: the largest modulus below 1 of the eigenvalues of the step's Jacobian over
/// positions, velocities and friction memory, by central differences.
///
/// Eigenvalues 1 (to 1e-6, what the differences resolve) are left out: friction holds a scene in a
/// continuum of states of rest, and the way from one to its neighbour never decays.
///
/// NaN where a disturbance of 1e-10 m makes or breaks a contact: then there is no Jacobian.
///
/// `rest` is a snapshot of this project's engine with these `settings`, time step included.
double slowest_rate(const Problem& problem, const Settings& settings, const Snapshot& rest);

}  // namespace stiction
