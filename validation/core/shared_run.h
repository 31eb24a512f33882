// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "validation/core/case_run.h"

namespace stiction {

/// What several variants of a case are held against, simulated once and not once for each. A case
/// file makes one for each case and lets the case's function keep it; a new catalog is a new one.
/// Every variant's record names it in its state hash and notes; its cost is in the record of the
/// variant that came first.
template <class Outcome>
class SharedRun {
 public:
  /// What `compute` returns, which depends on nothing but the run's settings with `over` over them.
  const Outcome& get(CaseRun& run, const Settings& over,
                     const std::function<Outcome(CaseRun&)>& compute) {
    Settings settings = run.settings();
    for (const auto& [name, value] : over) settings[name] = value;
    const std::lock_guard<std::mutex> lock(one_at_a_time_);
    Entry& entry = entries_[variant_text(settings)];
    const bool first = !entry.outcome;
    if (first) {
      CaseRun part = run.part(settings);
      entry.outcome = compute(part);
      entry.record = part.record();
    }
    run.include(entry.record, first);
    return *entry.outcome;
  }

 private:
  struct Entry {
    std::optional<Outcome> outcome;
    Record record;
  };
  std::mutex one_at_a_time_;
  std::map<std::string, Entry> entries_;  // nodes stay where they are
};

}  // namespace stiction
