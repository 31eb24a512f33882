// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "benchmarks/track/sizes/yardstick.h"
#include "reference/process/processors.h"
#include "reference/statistics/two_samples.h"

namespace stiction::track {

/// What was measured of one workload in one way: of each turn a sample, s a step.
struct StepTimes {
  Yardstick::Settled settled;
  std::vector<double> cpu, wall;
  std::map<std::string, std::vector<double>> phases;
  std::string hash;  ///< of the state that they end in; empty where that is not always the same
};

/// Whether both end in the same state, always.
inline bool same_state(const StepTimes& one, const StepTimes& other) {
  return !one.hash.empty() && one.hash == other.hash;
}

/// One workload in all ways, which took turns.
struct SizeResult {
  Workload workload;
  std::vector<Way> ways;         ///< the first is before, the second now
  std::vector<StepTimes> times;  ///< as many
  Yardstick::Limits limits;      ///< of the second
  /// Of each turn, what the processors were to threads before the steps of these and after; none where no way
  /// has threads.
  std::vector<std::array<reference::Together, 2>> together;

  const StepTimes& before() const { return times[0]; }
  const StepTimes& now() const { return times[1]; }
};

/// ns per contact and step of one way: medians over the turns.
double step_nanoseconds(const StepTimes& times);
/// The same by the clock on the wall.
double wall_nanoseconds(const StepTimes& times);
/// The sum of some phases; those that a revision hasn't got count nothing.
double phase_nanoseconds(const StepTimes& times, const std::vector<std::string>& phases);

/// Time of one over time of another, turn by turn: by their clocks of CPU time, or by that on the wall where
/// threads are compared. Each per contact.
reference::Quartiles ratio(const StepTimes& one, const StepTimes& other, bool by_wall = false);

/// Below this processors are near each other, s: of a machine shared with others two took 57 to 377 ns for an
/// answer in one minute and 490 to 770 in others.
inline constexpr double kNear = 400e-9;
/// The median of such ratios by the clock on the wall, of the turns in which processors were near each other
/// before the threads' steps and after; NaN of fewer than three.
double ratio_near(const SizeResult& result, const StepTimes& one, const StepTimes& other);

/// The ways of a comparison: another revision, the present one, that in each narrower register, and on so
/// many threads if that is more than one.
std::vector<Way> ways_of(const Tree& before, const Tree& now, int threads);

/// The present yardstick's workloads of whose names one of the globs matches one (none: all); long ones if
/// they are asked for. Throws TrackError when there is none.
std::vector<Workload> workloads_of(const Tree& now, const std::vector<std::string>& globs,
                                   bool full);

/// Settles a workload in each way, side by side, then has all take turns, there and back: A B C C B A …; and
/// starts all anew a few times where that is soon done.
SizeResult measure_size(const Workload& workload, const std::vector<Way>& ways);

}  // namespace stiction::track
