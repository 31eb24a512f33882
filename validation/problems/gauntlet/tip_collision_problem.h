// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "validation/problems/gauntlet/gauntlet_mesh.h"

namespace stiction {

/// Two free bodies without weight that meet tip on tip, or ridge on ridge, each with `speed` along z.
///
/// Their sides have a slope of tan = 0.5 < μ: what pushes them back along z lies within the friction
/// cone of each side, so that they part along z, wherever a tip strikes.
struct TipCollisionSetup {
  bool ridges = false;         ///< else spikes
  Vec2 offset = Vec2::Zero();  ///< of the upper tip, m
  double yaw = 0.0;            ///< of the upper body, degrees; 0: ridges are parallel
  double speed = 0.25;         ///< m/s
  double friction = 0.8;       ///< μ
  double duration = 0.1;       ///< s; contact takes some 20 ms
};

/// Bodies: lower (0), upper (1); 1 mm apart.
Problem tip_collision_problem(const TipCollisionSetup& setup);

std::string tip_collision_words(const TipCollisionSetup& setup);

}  // namespace stiction
