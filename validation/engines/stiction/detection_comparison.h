// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <random>

#include "solver/mesh/mesh.h"
#include "validation/engine/engine.h"

namespace stiction {

/// How the solver's inside tests and depths differ from exact ones. Lengths are over the body's
/// size, its bounding box's longest edge.
struct DetectionComparison {
  int points = 0, inside = 0, boundary = 0;
  int ties = 0;                 ///< inside, as near to several places of the surface
  int wrong_side = 0;           ///< a side other than the exact one …
  int wrong_beyond = 0;         ///< … farther from the surface than rounding reaches
  double farthest_wrong = 0.0;  ///< distance from the surface of a wrong side
  double depth_error = 0.0;     ///< largest, of those to the nearest place
  double foot_error = 0.0;      ///< largest distance of x + d n from the surface
  int not_nearest = 0;          ///< depths that are to another place than the nearest …
  double shallowest = std::numeric_limits<double>::infinity();  ///< … least deep, in mean edges

  void add(const DetectionComparison& other);
};

/// A barycentric weight of order one comes out of some thirty roundings of numbers of order one,
/// and the volume it is divided by is up to a hundred times smaller than a cube of the same edge.
inline constexpr double kDetectionRounding = 30.0 * 1.1e-16 * 100.0;

/// Asks the solver, set up by `settings`, and exact arithmetic about the same points in and about a
/// body at rest: `random` of those that a rounded calculation finds hard, and as many at random.
DetectionComparison compare_detection(const TetMesh& mesh, int random, std::mt19937& generator,
                                      const Settings& settings);

/// Moves every vertex by up to `share` of the shortest edge: no two faces are parallel any more.
TetMesh shaken(TetMesh mesh, double share, std::mt19937& generator);

}  // namespace stiction
