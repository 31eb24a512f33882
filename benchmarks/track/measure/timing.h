// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/track/decide/metric.h"
#include "benchmarks/track/measure/tree.h"

namespace stiction::track {

/// How long to time.
struct TimingPlan {
  int least_rounds = 12;  ///< runs of each program
  /// More rounds are added, up to this many, of benchmarks whose noise is above `wanted_floor`. It
  /// is the noise that decides, never the difference, so that looking does not raise false alarms.
  int most_rounds = 24;
  double wanted_floor =
      0.03;  ///< |ln ratio|; less is of no use below the layout floor (decide.cpp)
  /// In a round, each program times each benchmark so often, and the fastest counts: other work on
  /// the machine only ever adds time.
  int repetitions = 10;
  double seconds = 0.01;  ///< CPU time of one repetition, at least
};

/// Adds the sample "<benchmark>#time" (CPU time per contact, s) of each benchmark in one
/// run of the program, as Google Benchmark reports it.
/// Throws TrackError when the program fails or a benchmark is not in its output.
void time_once(const Tree& tree, const std::vector<std::string>& names, const TimingPlan& plan,
               Measurements& measured);

/// Times two revisions in turn, A B, B A, A B, … so that slow drifts of the machine meet both
/// alike. The trees may be one and the same.
void time_in_turn(const Tree& a, const Tree& b, const std::vector<std::string>& names,
                  const TimingPlan& plan, Measurements& of_a, Measurements& of_b);

}  // namespace stiction::track
