// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/lanes/lane_width.h"
#include "solver/parallel/team.h"

namespace stiction {

/// Throws InputError with one sentence when the environment asks for what this machine or build has
/// not: STICTION_WIDTH or STICTION_THREADS. For programs, before they begin.
inline void check_environment() {
  lane_width();
  step_threads();
}

}  // namespace stiction
