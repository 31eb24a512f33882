// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "validation/engine/engine.h"
#include "validation/engine/problem.h"

namespace stiction {

/// The paper's Fig. 6: non-convex objects fall into a basket. The basket is five rigid half-spaces,
/// a square floor and four walls that lean outwards.
struct BasketSetup {
  int columns = 3;            ///< objects a side of the lattice they fall from
  int layers = 3;             ///< columns² · layers objects in all
  double edge = 0.05;         ///< of the cubes that an object is made of, m
  int cells = 1;              ///< per cube edge
  double friction = 0.5;      ///< μ everywhere
  double floor_share = 0.5;   ///< the floor's width in terms of the lattice's
  double wall_tangent = 0.5;  ///< by how much a wall leans outwards, per height
  double density = 1000.0;    ///< kg/m³
  Elasticity elasticity{.youngs_modulus = 5e5, .poisson_ratio = 0.3, .damping_time = 1e-3};
  std::uint32_t seed = 1;  ///< of the rotations and of the small sideways shifts
};

/// Shapes in turn (L, T, U, plus, jack), each turned at random, dropped together from a lattice in
/// which every object has a cell of its own: nothing overlaps, whatever its rotation. Layers are
/// shifted against each other by half a cell.
Problem basket_problem(const BasketSetup& setup);

/// Where all the bodies are.
std::vector<BodyMotion> motions(const Engine& engine, std::size_t bodies);

}  // namespace stiction
