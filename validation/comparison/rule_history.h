// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "validation/comparison/scenes.h"
#include "validation/comparison/turnover.h"
#include "validation/core/case_run.h"
#include "validation/observe/observe.h"

namespace stiction {

/// What a rule made of a scene, from the step after the friction memory was lost.
struct RuleHistory {
  ContactSlips start;               ///< at the start
  std::vector<ContactSlips> slips;  ///< after each step
  std::vector<double> kinetic;      ///< J, after each step
  double time_step = 0.0;           ///< s
  Turnover turnover;
  double moved = 0.0;      ///< farthest body from where it had settled, at the end, m
  std::string failure;     ///< why it broke off before the end, or did not hold; else empty
  bool same_hash = false;  ///< the logged pass ended where the timed one did

  /// Steps until the mean slip (or that of the fastest contact) stays at `slip` (m/s) or below;
  /// infinity if it never does.
  double steps_to(double slip, double ContactSlips::*whose = &ContactSlips::mean) const;
  /// The same, counted from the last step in which it was above `above`, the start being step 0;
  /// NaN if it never was.
  double steps_from(double above, double slip, double ContactSlips::*whose) const;
  /// Mean slip over the last tenth of the steps, m/s.
  double creep() const;
  /// Σ mean slip · Δt: what was lost for good before friction was found again, m.
  double path() const;

 private:
  std::size_t last_above(double slip, double ContactSlips::*whose) const;  // step; 0: none
};

/// Runs the scene twice from the same state with the settings of the run: once timed, without
/// looking at it, which is what the record's cost and hash belong to; once looking after each step.
/// `extra` goes over the settings of the run, but not into how the scene settles. A program cannot take
/// up a state of another process, and is given its setting `settled` instead; such a scene is not released.
RuleHistory run_rule(CaseRun& run, const ComparisonScene& scene, const Settings& extra = {});

/// Adds the check that both passes are the same computation.
void check_same_hash(CaseRun& run, bool same);

/// Adds what a history says: steps, creep, path, energy, failure, memory; and the check that
/// both passes are the same computation.
void report_history(CaseRun& run, const RuleHistory& history);

/// Adds how many steps it takes from a slip of 1e-3 m/s, where the paper counts from, to 1e-9 m/s:
/// by the mean and by the fastest contact.
void report_from_sliding(CaseRun& run, const RuleHistory& history);

}  // namespace stiction
