// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

#include "validation/engine/problem.h"

namespace stiction::test {

/// A body of a random scene. Whole numbers, 0 the plainest, so that a counterexample shrinks to what
/// matters and can be kept as it was printed. `zigzag` 0, 1, 2, 3, 4 … stands for 0, 1, −1, 2, −2 …
struct RandomBody {
  int shape = 0;               ///< box, ball, tetrahedron, point
  int size = 0;                ///< 0.1, 0.2, 0.05 m: 0.1 · 2^zigzag
  int mass = 0;                ///< 10^zigzag kg
  std::array<int, 2> aside{};  ///< of the body below, zigzag · 0.01 m
  int gap = 0;                 ///< above what is below, 10 µm
  int axis = 0;                ///< of the rotation: x, y, z, (1, 1, 1), (3, −2, 1)
  int angle = 0;               ///< zigzag · 10°
  std::array<int, 3>
      velocity{};  ///< zigzag · 0.1 m/s, but down 0.1 m/s · (1, 2 … of what is higher)
  int spin = 0;    ///< about the axis, zigzag rad/s
};

/// What random scenes are made of: bodies one above the other, so that none starts in another.
struct RandomScene {
  int ground = 0;             ///< nothing, a half-space, a soft slab that is held below
  int slope = 0;              ///< of a half-space, degrees
  int gravity = 0;            ///< 1: that of the Earth
  int mu_decade = 0;          ///< μ = mu · 10^zigzag
  int mu = 0;                 ///< 0 … 9
  int damping = 0;            ///< β, 0.1 ms
  int drag = 0;               ///< 1/s
  std::array<int, 3> load{};  ///< on the first body, zigzag · ¼ of what it would weigh
  std::vector<RandomBody> bodies{};
};

double friction_of(const RandomScene& scene);
Problem problem_of(const RandomScene& scene);

/// As C++ that makes the same scene.
void show(std::ostream& stream, const RandomScene& scene);

}  // namespace stiction::test
