// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/measure/campaign.h"

#include <fmt/format.h>

#include <algorithm>

#include "benchmarks/track/measure/child.h"
#include "benchmarks/track/measure/fixed_runs.h"
#include "benchmarks/track/store/fingerprint.h"
#include "reports/record/environment.h"
#include "reports/screen/program.h"
#include "reports/screen/progress_line.h"

namespace stiction::track {

namespace {

using Names = std::vector<std::string>;

Names in_both(const Names& a, const Names& b) {
  Names both;
  std::copy_if(a.begin(), a.end(), std::back_inserter(both), [&](const std::string& name) {
    return std::find(b.begin(), b.end(), name) != b.end();
  });
  return both;
}

StoredRun run_of(const Project& project, const Tree& tree) {
  std::optional<Machine> machine = told_machine(tree);
  // A revision whose bench does not tell leaves it to the records of a case of milliseconds.
  if (!machine) {
    machine = measure_accuracy(tree, {"--case", "half-space/free-fall"}, project, false).machine;
  }
  return {.date = current_environment().date,
          .revision = tree.revision,
          .label = tree.label,
          .machine = *machine};
}

// Everything but times.
CaseAccuracy measure_counts(const Project& project, const Tree& tree, const Names& names,
                            const Scope& scope, StoredRun& run) {
  CaseAccuracy accuracy;
  if (scope.accuracy) {
    tell("stiction track: cases of " + tree.label);
    accuracy = measure_accuracy(tree, scope.cases, project, scope.fresh);
    run.measurements.merge(accuracy.measurements);
  }
  if (scope.counts) {
    tell("stiction track: counts of " + tree.label);
    ProgressLine progress(names.size());
    std::size_t done = 0;
    for (const std::string& name : names) {
      progress.show(done++, name);
      run.measurements.merge(count_fixed(tree, name, project, scope.fresh));
    }
  }
  return accuracy;
}

Names of_changed_times(const std::vector<Comparison>& comparisons) {
  Names names;
  for (const Comparison& one : comparisons) {
    if (one.metric.kind == Kind::kTime && one.change != Change::kSame) {
      names.push_back(one.metric.subject);
    }
  }
  return names;
}

void demand_same_machine(const StoredRun& before, const StoredRun& after) {
  const std::string what = difference(before.machine, after.machine);
  if (what.empty()) return;
  throw TrackError(
      fmt::format("{} and {} were built differently ({}); --any-machine compares them all the same",
                  before.label, after.label, what));
}

void demand_work(const Scope& scope) {
  if (!scope.times && !scope.counts && !scope.accuracy) {
    throw TrackError("without times, counts and cases there is nothing to measure");
  }
}

}  // namespace

Outcome compare_trees(const Project& project, const Tree& before, const Tree& after,
                      const Scope& scope) {
  demand_work(scope);
  Outcome outcome{.before = run_of(project, before), .after = run_of(project, after)};
  if (!scope.any_machine) demand_same_machine(outcome.before, outcome.after);
  Names names;
  if (scope.times || scope.counts) {
    names = in_both(fixed_benchmarks(before, scope.benchmarks),
                    fixed_benchmarks(after, scope.benchmarks));
    if (names.empty()) throw TrackError("no benchmark of this name is in both revisions");
  }
  const CaseAccuracy old_one = measure_counts(project, before, names, scope, outcome.before);
  const CaseAccuracy new_one = measure_counts(project, after, names, scope, outcome.after);
  for (const auto& [subject, hash] : new_one.state_hash) {
    const auto found = old_one.state_hash.find(subject);
    if (found == old_one.state_hash.end() || hash.empty()) continue;
    ++outcome.cases;
    outcome.bit_equal += found->second == hash ? 1 : 0;
  }
  if (scope.times) {
    tell("stiction track: times, in turn");
    time_in_turn(before, after, names, scope.timing, outcome.before.measurements,
                 outcome.after.measurements);
  }
  outcome.comparisons = compare(outcome.before.measurements, outcome.after.measurements);
  outcome.appeared = missing(outcome.after.measurements, outcome.before.measurements);
  outcome.disappeared = missing(outcome.before.measurements, outcome.after.measurements);
  const Names suspects = of_changed_times(outcome.comparisons);
  if (!suspects.empty()) {
    tell(fmt::format("stiction track: once more, to be sure: {}", fmt::join(suspects, ", ")));
    Measurements of_before, of_after;
    // Half as long again, so that a true change is not lost to a burst of noise.
    TimingPlan plan = scope.timing;
    plan.least_rounds += plan.least_rounds / 2;
    time_in_turn(before, after, suspects, plan, of_before, of_after);
    confirm(outcome.comparisons, compare(of_before, of_after));
    outcome.timed_twice = true;
  }
  return outcome;
}

StoredRun measure(const Project& project, const Tree& tree, const Scope& scope) {
  demand_work(scope);
  StoredRun run = run_of(project, tree);
  const Names names = fixed_benchmarks(tree, scope.benchmarks);
  if (names.empty()) throw TrackError("no benchmark of this name is in this revision");
  measure_counts(project, tree, names, scope, run);
  if (scope.times) {
    for (int k = 0; k < scope.timing.least_rounds; ++k) {
      time_once(tree, names, scope.timing, run.measurements);
    }
  }
  return run;
}

}  // namespace stiction::track
