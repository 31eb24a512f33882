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

/// How many times as fast as one thread a team goes through memory of which each has a piece of its own,
/// a = b + s c as above: by the clock on the wall, in turn. (Of arithmetic: reference::measure_together.)
double memory_gain(const Team& team);

/// What reading the thread's clock twice adds to a difference, s: the smallest of many.
double clock_overhead();

}  // namespace stiction::bench
