// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "validation/engines/bullet_deformable/parameters.h"

namespace stiction::bullet_deformable {

/// A body as tetrahedra, in its own frame about its centre of mass.
struct SoftMesh {
  std::vector<Eigen::Vector3d> nodes{};          ///< m
  std::vector<std::array<int, 4>> tetrahedra{};  ///< of positive volume
  std::vector<std::array<int, 3>> surface{};     ///< outward
  std::vector<double> masses{};                  ///< kg, lumped
};

/// A box as a grid of cells of six tetrahedra each; a ball as such a cube, drawn onto it shell by
/// shell; a mesh as it is given.
SoftMesh soft_mesh(const stiction_body& body, const Parameters& parameters);

}  // namespace stiction::bullet_deformable
