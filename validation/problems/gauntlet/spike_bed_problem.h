// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "validation/problems/gauntlet/gauntlet_mesh.h"

namespace stiction {

/// A body on a bed of 4 × 3 spikes, 30 mm apart and 20 mm high: a box on their tips, or 2 × 2 spikes
/// that point down between them.
struct SpikeBedSetup {
  bool spikes = false;        ///< the body has spikes; else it is a box
  double height = 0.025;      ///< of its spikes, m
  Vec2 shift = Vec2::Zero();  ///< of the body from the bed's middle, m
  double yaw = 0.0;           ///< of the body, degrees
  double drop = 0.0;          ///< of its lowest points over the bed's tips, m; < 0: between them
  double friction = 0.5;      ///< μ
  Drag drag{.rate = 15.0, .full_until = 2.1, .ends = 2.4};
};

/// Bodies: the upper one (0), the bed (1), whose lower face is held. Gravity grows to full in 0.4 s.
Problem spike_bed_problem(const SpikeBedSetup& setup);

inline constexpr double kBedHeight = 0.02;  ///< of the bed's spikes, m
inline constexpr double kBedPad = 0.03;     ///< from tip to tip, m

std::string spike_bed_words(const SpikeBedSetup& setup);

}  // namespace stiction
