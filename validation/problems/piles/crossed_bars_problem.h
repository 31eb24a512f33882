// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "validation/engine/problem.h"

namespace stiction {

/// A bar laid flat across another: only edges cross edges, because the meshes are so coarse that no
/// vertex of one lies over the other.
struct CrossedBarsSetup {
  double angle = 90.0;       ///< between the bars, degrees
  double along_lower = 0.0;  ///< where they cross, from the lower bar's middle, m
  double along_upper = 0.0;  ///< … and from the upper bar's, m
  bool on_supports = false;  ///< the lower bar lies on two held blocks; else its lower face is held
  Vec3 size{0.4, 0.05, 0.05};  ///< of a bar, m
  int cells = 3;               ///< along a bar; one across
  double friction = 0.5;       ///< μ
  double density = 1000.0;     ///< kg/m³
  /// So soft that a step is as large as those of other piles.
  Elasticity elasticity{.youngs_modulus = 2.5e6, .poisson_ratio = 0.3, .damping_time = 2e-4};
  Drag drag{.rate = 20.0, .full_until = 2.0, .ends = 3.0};  ///< gone before rest is judged
};

/// Bodies: upper bar (0), lower bar (1), then the supports. Gravity grows to full in 0.4 s.
Problem crossed_bars_problem(const CrossedBarsSetup& setup);

/// Least distance of a vertex of one bar, seen from above, from the outline of the other: positive
/// while no vertex lies over the other bar, m.
double clearance(const CrossedBarsSetup& setup);

/// Sixteen: four angles, crossing in the middle and off it, held and on supports.
std::vector<CrossedBarsSetup> crossed_bars();

std::string crossed_bars_words(const CrossedBarsSetup& setup);

}  // namespace stiction
