// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "benchmarks/workloads/workload.h"

namespace stiction::bench {

/// What is timed: one phase of a step, or the whole step.
struct Timed {
  std::string name;  ///< "detect", "friction:fixed-point", "step": without spaces
  Phase phase{};     ///< unused by `whole_step`
  bool whole_step = false;
  std::string rule;     ///< friction rule that the state was warmed with
  bool afresh = false;  ///< the search for pairs makes its lists anew

  /// Whether what it does depends on how far all has moved since the last step: taken once more from where
  /// it has just been, nothing has, and it finds all that it asks for known.
  bool goes_on() const {
    return whole_step || (phase == Phase::kDetect && !afresh) || phase == Phase::kDepth;
  }
};

/// Steps of a batch of what goes on. After what is done between two batches, one thread's copying of the
/// workload, the others have nothing of it in their caches and may be asleep.
inline constexpr int kStepsInARow = 32;

/// Every phase, detection also with its lists made anew (in a scene at rest they last), friction
/// once a rule of the catalog, and the whole step.
std::vector<Timed> timed_parts();

/// "friction:fixed-point/slab/contacts:1000"
std::string benchmark_name(const Timed& timed, const std::string& family, int size);

/// Copies of what a part of the step starts from, and the part itself: each batch does the same
/// work on the same warm data.
class Batch {
 public:
  /// `settled` must outlive it.
  Batch(const Workload& settled, const Timed& timed);

  void restore();  ///< undoes what `run` changed; not to be timed
  /// The part of the step, once, by the threads of a team if there is one.
  void run(const Team* team = nullptr);

  /// Seconds of a part, by the clock of this thread and by that on the wall: of a phase of steps that go on
  /// both are the wall's.
  struct Seconds {
    double cpu = 0.0, wall = 0.0;
  };
  /// To be called once before what counts: allocates what batches need.
  void warm();
  /// One batch, from where each begins: `steps` times the part, in steps that go on if it does; else once.
  /// A part is done by the team; whole steps by the team or one thread, whoever takes less just then.
  Seconds time(const Team* team = nullptr);
  int steps() const { return timed_.goes_on() ? kStepsInARow : 1; }

  /// Of all that the part wrote, with the state: equal hashes, equal work.
  std::uint64_t hash() const;

  const Workload& work() const { return work_; }

 private:
  void begin();                          // of steps that go on
  const Team* chosen(const Team& team);  // who takes less for whole steps: the team, or null
  Seconds time_going_on(const Team* team);

  const Workload& settled_;
  Workload work_;
  Timed timed_;
  State start_;
  std::vector<Velocity> velocity_;  // of the workspace, where the part changes it
  PairContacts pairs_;
};

}  // namespace stiction::bench
