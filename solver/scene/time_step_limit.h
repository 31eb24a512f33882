// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/scene/scene.h"

namespace stiction {

/// Largest stable time step of one element, s: symplectic Euler with viscous damping β needs
/// Δt ≤ √(β² + 4/ω²) − β, with ω² the largest eigenvalue of the lumped element; the smallest
/// element value bounds the mesh [IronsTreharne1971].
double element_time_step_limit(const TetMesh& mesh, Eigen::Index tetrahedron,
                               const Material& material);

/// Largest stable time step of a body near its rest shape, s; infinite without elements that can
/// move. It is 1.1 to 2.6 times the smallest of its elements', who don't know that neighbours hold
/// them (boxes and balls, measured). In a body that is crumpled elements are turned against each
/// other and stiffer together than at rest: it then breaks below this limit, and if it is damped
/// mostly not below that of elements (time_step_limit_test.cpp). From the largest eigenvalue of the
/// assembled matrix by powers of it, hence from above: by less than 1 %, measured.
double body_time_step_limit(const BodyDescription& body);

}  // namespace stiction
