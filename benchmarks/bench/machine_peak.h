// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/parallel/team.h"

namespace stiction::bench {

/// What this machine can do on one core now, with the flags of this build: the scale of the cost
/// model.
struct MachinePeak {
  double bytes_per_second = 0.0;  ///< memory bandwidth: a = b + s c on arrays larger than caches
  double flops_per_second = 0.0;  ///< double precision: independent chains of x ← a x + b
};

/// Measures both, best of several; takes about half a second.
MachinePeak measure_peak();

/// How many times as fast as one thread a team does work that shares nothing, piece by piece: what the
/// machine has to give to threads inside a step.
struct TeamPeak {
  double arithmetic = 1.0;  ///< chains as above
  double memory = 1.0;      ///< a = b + s c as above
};

/// Measures both by the clock on the wall, one thread and the team in turn.
TeamPeak measure_team_peak(const Team& team);

/// What reading the thread's clock twice adds to a difference, s: the smallest of many.
double clock_overhead();

}  // namespace stiction::bench
