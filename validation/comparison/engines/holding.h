// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "validation/comparison/engines/answers.h"

namespace stiction {

// What holds, as engines go: it creeps less than a nanometre a second, and gives within a hundredth
// of a degree of the critical slope.
inline constexpr double kCreeps = 1e-9;    // m/s
inline constexpr double kGivesOff = 0.01;  // °

/// The least and largest error of the slopes that give, and the fastest creep, over the directions.
struct Holding {
  double least = std::numeric_limits<double>::infinity();  ///< °; −90: gives on every slope
  double most = -least;                                    ///< °; 90: on none
  double creep = 0.0;                                      ///< m/s; infinite where it broke
  bool asked = false, creep_asked = false;

  bool holds() const {
    return asked && creep_asked && creep <= kCreeps && least > -kGivesOff && most < kGivesOff;
  }
};

Holding holding(const EngineAnswers& answers, const EngineRow& row);

}  // namespace stiction
