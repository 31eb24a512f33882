// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/track/decide/metric.h"
#include "benchmarks/track/measure/tree.h"

namespace stiction::track {

/// Names of the fixed benchmarks of a revision that match one of the globs (all when there are
/// none), in its order. Throws TrackError for a `bench` without --list-fixed: it could not be
/// measured.
std::vector<std::string> fixed_benchmarks(const Tree& tree, const std::vector<std::string>& globs);

/// What `count_fixed` may measure.
inline const std::vector<std::string> kCounted = {"instructions", "contact updates", "sweeps",
                                                  "allocations", "digits: error"};

/// What exactly so much work costs and gives, counted, not timed:
///   instructions     of a batch, (callgrind at 3 batches − callgrind at 1) / 2, per contact; not
///                    there without valgrind
///   contact updates  of a batch, whatever the sweeps
///   sweeps           of the friction phase over its contacts, of a batch
///   allocations      of a batch
///   digits: error    −log₁₀ of the workload's error
/// Deterministic, so remembered in `work`/counts by the program's content and the machine: a
/// program is counted once. Throws TrackError when the program fails.
Measurements count_fixed(const Tree& tree, const std::string& name, const Project& project,
                         bool fresh);

}  // namespace stiction::track
