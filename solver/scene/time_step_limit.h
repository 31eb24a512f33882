// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/scene/scene.h"

namespace stiction {

/// Lamé's parameters of a material, Pa.
struct Lame {
  double mu;
  double lambda;
};

Lame lame(const Material& material);

/// Columns x₁ − x₀, x₂ − x₀, x₃ − x₀ of a tetrahedron at rest, m.
Eigen::Matrix3d rest_edges(const TetMesh& mesh, Eigen::Index tetrahedron);

/// Largest stable time step of one element, s: symplectic Euler with viscous damping β needs
/// Δt ≤ √(β² + 4/ω²) − β, with ω² the largest eigenvalue of the lumped element; the smallest
/// element value bounds the mesh [IronsTreharne1971].
double element_time_step_limit(const TetMesh& mesh, Eigen::Index tetrahedron,
                               const Material& material);

/// Largest stable time step of a body near its rest shape, s; infinite without elements that can
/// move. It is 1.1 to 2.5 times the smallest of its elements', who don't know that neighbours hold
/// them; but in a body that is crumpled elements are turned against each other and stiffer together
/// than at rest, and there that of elements holds, if the body is damped. From the largest
/// eigenvalue of the assembled matrix by powers of it, hence from above: by less than 1 %, measured.
double body_time_step_limit(const BodyDescription& body);

/// Of each vertex, kg: a quarter of each of its tetrahedra, or the body's point mass.
std::vector<double> lumped_masses(const BodyDescription& body);

}  // namespace stiction
