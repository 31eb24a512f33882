// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "reference/meshes/closed_surface.h"
#include "solver/mesh/mesh.h"

/// Internal to closed surfaces: what the program mesh_surface and those who call it say to each
/// other.
///
///   mesh_surface [--cell-size M] [--facet-distance M] [--feature-angle DEGREES] [--seed N]
///                [--most-tetrahedra N] [--unit M] [--reading-limit S] FILE
///
/// writes the filled surface to stdout, as text:
///
///   stiction filled surface 1                  version of this format
///   given TRIANGLES VOLUME                     of the file's surface; m³
///   vertices N
///   X Y Z                                      N lines, m
///   tetrahedra M
///   A B C D                                    M lines, vertex indices from 0
///   end
///
/// Numbers are the shortest decimals that read back as the same double. Once the surface is found
/// good, and before it is filled, stderr has a line
///
///   expected TETRAHEDRA CELL_SIZE              about so many; m
///
/// When there is nothing to write, the last line of stderr is one sentence, and the exit code says
/// whose fault it is.
namespace stiction::reference {

inline constexpr const char* kExpected = "expected";

enum MesherExit {
  kFilled = 0,
  kMesherFailed = 2,  ///< wrong arguments, or the mesher itself: nothing is known of the surface
  kFirstFlaw = 16     ///< this + SurfaceFlaw: the surface was refused
};

/// What the mesher knows; the rest of a SurfaceReport is measured from the mesh.
struct FilledSurface {
  Eigen::Index given_triangles = 0;
  double given_volume = 0.0;  ///< m³
  TetMesh mesh;
};

std::string to_text(const FilledSurface& filled);

/// Throws std::invalid_argument, with what is wrong, unless the text is whole, its numbers finite
/// and its indices in range.
FilledSurface filled_surface_from(std::string_view text);

}  // namespace stiction::reference
