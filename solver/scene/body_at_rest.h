// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "solver/scene/scene.h"

namespace stiction {

/// Lamé's parameters of a material, Pa.
struct Lame {
  double mu;
  double lambda;
};

Lame lame(const Material& material);

/// Columns x₁ − x₀, x₂ − x₀, x₃ − x₀ of a tetrahedron, m.
Eigen::Matrix3d rest_edges(const TetMesh& mesh, Eigen::Index tetrahedron);

/// Of each vertex, kg: a quarter of each of its tetrahedra, or the body's point mass.
std::vector<double> lumped_masses(const BodyDescription& body);

}  // namespace stiction
