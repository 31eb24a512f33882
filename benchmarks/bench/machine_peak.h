// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace stiction::bench {

/// What this machine can do on one core now, with the flags of this build: the scale of the cost
/// model.
struct MachinePeak {
  double bytes_per_second = 0.0;  ///< memory bandwidth: a = b + s c on arrays larger than caches
  double flops_per_second = 0.0;  ///< double precision: independent chains of x ← a x + b
};

/// Measures both, best of several; takes about half a second.
MachinePeak measure_peak();

/// What reading the thread's clock twice adds to a difference, s: the smallest of many.
double clock_overhead();

}  // namespace stiction::bench
