// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "validation/problems/gauntlet/gauntlet_mesh.h"

namespace stiction {

/// What a balancing body stands on.
enum class Perch {
  kFlat,   ///< a face of 2 × 2 cells, their common vertex in the middle
  kSpike,  ///< a blunt spike, its sides at 27°: tan = 0.5
  kRidge,  ///< an edge along y, its sides at 45°
  kValley  ///< a groove along y, its sides at 30°
};

/// A body with legs so heavy that its centre of mass lies below what it stands on: it balances on
/// one vertex, or one edge, and swings like a pendulum until the medium has stopped it.
struct BalanceSetup {
  Foot foot = Foot::kSpike;
  Perch perch = Perch::kFlat;
  Vec2 offset = Vec2::Zero();  ///< of the foot from the perch's middle, m
  double foot_yaw = 0.0;       ///< of the body about the vertical, degrees
  double perch_yaw = 0.0;      ///< degrees
  double friction = 0.8;       ///< μ
};

/// Bodies: the balancing one (0), the perch (1), whose lower face is held. Gravity grows to full in
/// 0.4 s. A medium of nearly the critical rate of the slowest swing, 2 √(g d/(k² + d²)) with the centre
/// d below the foot (18 mm, a hook's 39 mm), is gone at 3.7 s.
Problem balance_problem(const BalanceSetup& setup);

/// Where the foot's tip, or the ridge that carries it, is at the start, m.
Vec3 foot_at(const BalanceSetup& setup);

std::string balance_words(const BalanceSetup& setup);

}  // namespace stiction
