// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "validation/problems/slopes/membrane_problem.h"

namespace stiction {

/// The box on the string from the moment on at which the slope begins to turn.
struct MembraneReference {
  std::vector<double> time, place, kinetic;  ///< s, m along the stretched chord, J
  double length = 0.0;                       ///< of the strip under full load, m
};

/// The string model of the whole experiment with a start of its own, which takes nothing from a
/// simulation: the box lies at `setup.start` of the strip's material until friction gives, while
/// gravity turns from the first slope to the full one as in membrane_problem; from then on the full
/// law (reference/motion/membrane.h). Turning is done in `parts` equal parts, in each of which
/// slope and tension are those of its middle: an error of order 1/parts². Samples at `interval` (s)
/// up to `end`.
MembraneReference membrane_reference(const MembraneSetup& setup, double end, double interval,
                                     int parts = 160);

}  // namespace stiction
