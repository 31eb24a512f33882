// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "validation/problems/gauntlet/gauntlet_mesh.h"

namespace stiction {

/// A box on a support, partly over its edge.
///
///   it stays iff its centre of mass lies over the support: inside > 0
struct CliffSetup {
  double inside = 0.005;       ///< of the box's centre from the support's edge, m
  double yaw = 0.0;            ///< of the box about the vertical, degrees
  Vec3 size{0.1, 0.06, 0.04};  ///< of the box, m
  double friction = 0.5;       ///< μ
  Drag drag{.rate = 15.0, .full_until = 1.4, .ends = 1.8};
};

/// Bodies: the box (0), the support (1), whose lower face is held and whose edge is x = 0, z = 0.
/// Gravity grows to full in 0.4 s.
Problem cliff_problem(const CliffSetup& setup);

std::string cliff_words(const CliffSetup& setup);

}  // namespace stiction
