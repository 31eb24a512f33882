// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "solver/mesh/mesh.h"

/// Coarse non-convex bodies that hook into one another, for the basket case: equal cubes joined at
/// faces, each cut into five tetrahedra (one regular, four at corners). Cubes at odd and even
/// places are mirror images, so that the diagonals of shared faces coincide. Shortest altitude:
/// edge/√3.
namespace stiction::reference {

enum class Shape {
  l,     ///< 4 cubes, 20 vertices
  t,     ///< 4 cubes, 20 vertices
  u,     ///< 5 cubes, 24 vertices: a hook
  plus,  ///< 5 cubes in a plane, 24 vertices
  jack,  ///< 7 cubes, 32 vertices: an arm along each half-axis
};

inline constexpr Shape kShapes[] = {Shape::l, Shape::t, Shape::u, Shape::plus, Shape::jack};

/// "l", "t", "u", "plus", "jack".
std::string name(Shape shape);

/// Integer places of the cubes.
std::vector<Eigen::Vector3i> cubes(Shape shape);

/// The body with its centre of mass at the origin. `edge`: of a cube, m; `cells`: per cube edge, so
/// that 2 gives eight times the tetrahedra. Throws std::invalid_argument for an edge that is not
/// finite and positive or `cells` outside [1, 64].
TetMesh shape_mesh(Shape shape, double edge, int cells = 1);

/// Volume of the body: cubes · edge³, m³.
double shape_volume(Shape shape, double edge);

}  // namespace stiction::reference
