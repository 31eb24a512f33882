// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/command/bisect.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "benchmarks/track/command/known_metric.h"
#include "benchmarks/track/measure/child.h"
#include "reports/screen/program.h"

namespace stiction::track {

namespace {

std::optional<Comparison> comparison_of(const Outcome& outcome, const std::string& metric) {
  for (const Comparison& one : outcome.comparisons) {
    if (one.metric.name() == metric) return one;
  }
  return std::nullopt;
}

}  // namespace

Scope scope_of_metric(const std::string& metric, Scope scope) {
  const std::size_t sign = metric.find('#');
  if (sign == std::string::npos) {
    throw TrackError(fmt::format(
        "'{}' is no metric: its name is SUBJECT#WHAT, as `track history` shows", metric));
  }
  const std::string subject = metric.substr(0, sign), what = metric.substr(sign + 1);
  // A benchmark is named PHASE/FAMILY/contacts:N; no case has such a part.
  const bool benchmark = subject.find("/contacts:") != std::string::npos;
  scope.times = benchmark && what == "time";
  scope.counts = benchmark && what != "time";
  scope.accuracy = !benchmark;
  if (benchmark) {
    scope.benchmarks = {subject};
  } else {
    scope.cases = {"--full", "--case", subject.substr(0, subject.find('@'))};
  }
  return scope;
}

std::optional<Found> first_moved(const std::vector<std::string>& commits, const Probe& probe) {
  if (commits.empty()) return std::nullopt;
  const std::optional<Comparison> last = probe(commits.back());
  if (!last) {
    throw TrackError(fmt::format("{} cannot be measured", commits.back().substr(0, 12)));
  }
  if (last->change == Change::kSame) return std::nullopt;
  // Moved at `moved`; not moved before `first`; between them nothing is known but of `silent`.
  std::size_t first = 0, moved = commits.size() - 1;
  Comparison found = *last;
  std::map<std::size_t, bool> silent;
  for (;;) {
    // The untried revision that is nearest to the middle.
    const std::size_t middle = first + (moved - first) / 2;
    std::optional<std::size_t> next;
    const auto distance = [&](std::size_t k) { return k < middle ? middle - k : k - middle; };
    for (std::size_t k = first; k < moved; ++k) {
      if (!silent[k] && (!next || distance(k) < distance(*next))) next = k;
    }
    if (!next) break;
    const std::optional<Comparison> one = probe(commits[*next]);
    if (!one) {
      silent[*next] = true;
    } else if (one->change == Change::kSame) {
      first = *next + 1;
    } else {
      moved = *next;
      found = *one;
    }
  }
  return Found{
      commits[moved],
      found,
      {commits.begin() + static_cast<long>(first), commits.begin() + static_cast<long>(moved)}};
}

std::optional<Found> bisect(const Project& project, const std::string& metric,
                            const std::string& good, const std::string& bad, const Scope& scope,
                            const std::filesystem::path& history) {
  const Scope narrow = scope_of_metric(metric, scope);
  const std::string good_commit = commit_of(project, good), bad_commit = commit_of(project, bad);
  const std::vector<std::string> commits = commits_between(project, good_commit, bad_commit);
  demand_known(project, metric, narrow, history);
  const Tree before = build_tree(project, good_commit);
  const auto probe = [&](const std::string& commit) -> std::optional<Comparison> {
    tell("stiction track: " + subject_of(project, commit));
    try {
      const Outcome outcome = compare_trees(project, before, build_tree(project, commit), narrow);
      const std::optional<Comparison> one = comparison_of(outcome, metric);
      if (!one && commit == bad_commit) {
        throw TrackError(fmt::format("'{}' is not measured by {} and {} both", metric, good, bad));
      }
      return one;
    } catch (const TrackError& error) {
      if (commit == bad_commit) throw;
      tell(fmt::format("stiction track: stepped over: {}", error.what()));
      return std::nullopt;
    }
  };
  return first_moved(commits, probe);
}

}  // namespace stiction::track
