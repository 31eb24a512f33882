// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/mesh/mesh.h"

namespace stiction::reference {

/// How well shaped the tetrahedra of a mesh are, in floating point.
struct MeshQuality {
  double min_dihedral_angle = 0.0;  ///< degrees; 0 where a tetrahedron is flat
  double max_dihedral_angle = 0.0;  ///< degrees; 180 where a tetrahedron is flat
  double min_altitude = 0.0;        ///< m: what an explicit time step sees
  /// Largest ratio of a tetrahedron's longest edge to its shortest altitude, dimensionless:
  /// √(3/2) = 1.22 for a regular one, infinite for a flat one. Slivers, which a radius–edge ratio
  /// passes, show in it.
  double max_aspect_ratio = 0.0;
};

/// Throws std::invalid_argument for a mesh without tetrahedra or a vertex index out of range.
MeshQuality mesh_quality(const TetMesh& mesh);

}  // namespace stiction::reference
