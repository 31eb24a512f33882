// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "reports/recording/frames.h"

namespace stiction {

/// For tests: a box of 0.2 × 0.2 × 0.1 m slides 1 m on level ground, slows down and sticks in the
/// last quarter. Weight 9.81 N and friction of half of it, on its four lower corners.
inline Recording sliding_box() {
  constexpr std::size_t kFrames = 41;
  Recording recording;
  recording.title = "a box slides and stops";
  recording.planes.push_back({"ground", {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}});
  recording.bodies.push_back({"box",
                              8,
                              {{0, 2, 1},
                               {0, 3, 2},
                               {4, 5, 6},
                               {4, 6, 7},
                               {0, 1, 5},
                               {0, 5, 4},
                               {1, 2, 6},
                               {1, 6, 5},
                               {2, 3, 7},
                               {2, 7, 6},
                               {3, 0, 4},
                               {3, 4, 7}}});
  const Triple corners[8] = {{-0.1, -0.1, 0.0}, {0.1, -0.1, 0.0},  {0.1, 0.1, 0.0},
                             {-0.1, 0.1, 0.0},  {-0.1, -0.1, 0.1}, {0.1, -0.1, 0.1},
                             {0.1, 0.1, 0.1},   {-0.1, 0.1, 0.1}};
  for (std::size_t i = 0; i < kFrames; ++i) {
    const double along = static_cast<double>(i) / 30.0;  // 1 when it stops
    const bool sticks = along >= 1.0;
    const double travel = sticks ? 1.0 : along * (2.0 - along);
    Frame frame;
    frame.time = 0.01 * static_cast<double>(i);
    frame.gravity = {0.0, 0.0, -9.81};
    for (const Triple& corner : corners) {
      frame.positions.push_back({corner[0] + travel, corner[1], corner[2]});
    }
    for (std::size_t c = 0; c < 4; ++c) {
      frame.contacts.push_back({frame.positions[c],
                                {0.0, 0.0, 9.81 / 4.0},
                                {sticks ? 0.0 : -9.81 / 8.0, 0.0, 0.0},
                                sticks});
    }
    recording.frames.push_back(frame);
  }
  return recording;
}

}  // namespace stiction
