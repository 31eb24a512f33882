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
};

/// Every phase, detection also with its lists made anew (in a scene at rest they last), friction
/// once a rule of the catalog, and the whole step.
std::vector<Timed> timed_parts();

/// "friction:fixed-point/slab/contacts:1000"
std::string benchmark_name(const Timed& timed, const std::string& family, int size);

/// Copies of what a part of the step starts from, and the part itself: each batch does the same
/// work on the same warm data.
class Batch {
 public:
  Batch(const Workload& settled, const Timed& timed);

  void restore();  ///< undoes what `run` changed; not to be timed
  /// One batch: the part of the step, once, by the threads of a team if there is one.
  void run(const Team* team = nullptr);

  /// Of all that the part wrote, with the state: equal hashes, equal work.
  std::uint64_t hash() const;

  const Workload& work() const { return work_; }

 private:
  Workload work_;
  Timed timed_;
  State start_;
  std::vector<Velocity> velocity_;  // of the workspace, where the part changes it
  PairContacts pairs_;
};

}  // namespace stiction::bench
