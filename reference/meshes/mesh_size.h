// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace stiction::reference {

/// How many tetrahedra CGAL's mesher will make of a closed surface, told before it is run.
///
/// Tetrahedra are about as large as is allowed, but no larger than the body is thick, as flat ones
/// would not be well shaped: N ≈ 5 V / h³, where h = min(cell size, 2 V / A). Of cubes, plates and rods
/// it is right within a factor of 2 (measured in mesh_surface_test.cpp).
/// All in powers of one unit of length.
struct MeshSize {
  double volume = 0.0;     ///< V
  double area = 0.0;       ///< A
  double cell_size = 0.0;  ///< circumradius of a tetrahedron at most

  [[nodiscard]] double thickness() const;   ///< 2 V / A: that of a plate
  [[nodiscard]] double tetrahedra() const;  ///< N
  /// What to change, in words, for a mesh of so many at most; lengths times `unit`.
  [[nodiscard]] std::string advice(double most, double unit = 1.0) const;
};

/// "1300", "200 000", "5.2 million": two digits of what is known no better.
std::string in_words(double count);

}  // namespace stiction::reference
