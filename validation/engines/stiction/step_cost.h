// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "reports/record/record.h"
#include "solver/workspace.h"

namespace stiction {

/// What the solver's steps have cost. Phases are timed in some steps only and scaled up to all:
/// reading the clock would otherwise be a tenth of the step of a small scene.
class StepCost {
 public:
  StepCost();

  /// Where the step of this number is to add what its phases take; null if it is not timed.
  PhaseSeconds* phases_of(std::uint64_t step);

  /// Counts the step that the workspace has just been used for.
  void add_step(const Workspace& workspace);

  void add_cpu(double seconds) { cpu_seconds_ += seconds; }
  double cpu_seconds() const { return cpu_seconds_; }
  std::uint64_t steps() const { return steps_; }
  Cost total(std::uint64_t contact_updates) const;

 private:
  struct PerContact {
    double contact_phases, whole_step;  // s
  };

  void note_contact_time(std::size_t contacts);
  ContactTime time_of(double PerContact::*part) const;
  void thin_out();

  double overhead_;  // what an empty PhaseTimer adds, s
  PhaseSeconds phase_seconds_{};
  double cpu_seconds_ = 0.0;
  std::uint64_t steps_ = 0;
  std::uint64_t timed_steps_ = 0;
  // Of the timed steps so far.
  double contact_seconds_ = 0.0, all_seconds_ = 0.0;
  // Of timed steps, one of every `stride_` and kMostTimes at most: the median shrugs off interrupts.
  std::vector<PerContact> seconds_per_contact_;
  std::uint64_t stride_ = 1;
  std::uint64_t with_contacts_ = 0;  // timed steps that had some
};

}  // namespace stiction
