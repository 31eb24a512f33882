// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmarks/track/decide/accuracy.h"
#include "benchmarks/track/decide/decide.h"
#include "benchmarks/track/measure/timing.h"
#include "benchmarks/track/measure/tree.h"
#include "benchmarks/track/store/history.h"

namespace stiction::track {

/// What to measure, and how long.
struct Scope {
  std::vector<std::string> benchmarks{};  ///< globs over the fixed benchmarks; empty: all
  CaseOptions cases{};                    ///< of validate
  TimingPlan timing{};
  bool times = true;         ///< measure times
  bool counts = true;        ///< count instructions and the like
  bool accuracy = true;      ///< run the cases
  bool fresh = false;        ///< count and compute anew what is remembered
  bool any_machine = false;  ///< compare builds of different compilers or flags too
};

/// Two revisions, measured side by side.
struct Outcome {
  StoredRun before, after;                 ///< what was measured, for the history
  std::vector<Comparison> comparisons{};   ///< worst first
  std::vector<std::string> appeared{};     ///< metrics that only `after` has
  std::vector<std::string> disappeared{};  ///< metrics that only `before` has
  int cases = 0;                           ///< subjects whose end states were compared
  int bit_equal = 0;                       ///< of them, those that are equal to the last bit
  bool timed_twice = false;                ///< a second run was needed to confirm the first
};

/// Measures both and decides, metric by metric; a change in time counts only when a second,
/// independent run finds it again. Throws TrackError when something cannot be measured, and for
/// builds of different machines unless `any_machine`.
Outcome compare_trees(const Project& project, const Tree& before, const Tree& after,
                      const Scope& scope);

/// Measures one revision alone, for the history.
StoredRun measure(const Project& project, const Tree& tree, const Scope& scope);

}  // namespace stiction::track
