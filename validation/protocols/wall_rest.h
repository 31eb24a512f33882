// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/core/case_run.h"
#include "validation/problems/piles/wall_problem.h"

namespace stiction {

/// A pile settles for `settled` (s) and is watched for as long again: how far its topmost course
/// has come down, how far anything has gone to the side, how fast anything moves on, and its energy
/// at the end.
void check_wall(CaseRun& run, const WallSetup& setup, double settled, const Accuracy& accuracy);

}  // namespace stiction
