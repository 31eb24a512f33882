// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/command/known_metric.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "benchmarks/track/measure/child.h"
#include "benchmarks/track/measure/fixed_runs.h"
#include "benchmarks/track/store/history.h"

namespace stiction::track {

namespace {

using Names = std::vector<std::string>;

bool is_in(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Names of_history(const std::filesystem::path& file) {
  std::error_code none;
  return std::filesystem::exists(file, none) ? History(file, Access::kRead).metrics() : Names();
}

Names names_of(const Measurements& measurements) {
  Names names;
  for (const auto& [name, measurement] : measurements.all()) names.push_back(name);
  return names;
}

// The metrics of one benchmark, counted when `what` may be among the counts.
Names of_benchmark(const Project& project, const Tree& tree, const std::string& subject,
                   const std::string& what) {
  Names names = {subject + "#time"};
  if (!is_in(kCounted, what)) {
    for (const std::string& counted : kCounted) names.push_back(subject + "#" + counted);
    return names;
  }
  for (const std::string& name : names_of(count_fixed(tree, subject, project, false))) {
    names.push_back(name);
  }
  return names;
}

// The metrics of the case that the scope names; none when there is no such case.
Names of_case(const Project& project, const Tree& tree, const Scope& narrow) {
  try {
    return names_of(measure_accuracy(tree, narrow.cases, project, false).measurements);
  } catch (const TrackError&) {
    return {};
  }
}

std::string all_of(const Names& benchmarks) {
  std::string text;
  for (const std::string& subject : benchmarks) {
    text += fmt::format("\n  {}#WHAT, WHAT being time, {}", subject, fmt::join(kCounted, ", "));
  }
  return text +
         "\n  CASE#verdict, CASE#contact updates, CASE#verdict: CHECK, CASE#digits: CHECK "
         "(./stiction validate --list --full names the cases)";
}

}  // namespace

void demand_known(const Project& project, const std::string& metric, const Scope& narrow,
                  const std::filesystem::path& history) {
  const Tree tree = present_tree(project);
  const std::string subject = metric.substr(0, metric.find('#'));
  const std::string what = metric.substr(subject.size() + 1);
  const Names benchmarks = fixed_benchmarks(tree, {});
  Names there;
  if (is_in(benchmarks, subject)) {
    there = of_benchmark(project, tree, subject, what);
  } else if (narrow.accuracy) {
    there = of_case(project, tree, narrow);
  }
  if (is_in(there, metric) || is_in(of_history(history), metric)) return;
  std::string listed;
  for (const std::string& name : there) listed += "\n  " + name;
  throw TrackError(fmt::format("there is no metric '{}'; there are:{}", metric,
                               listed.empty() ? all_of(benchmarks) : listed));
}

}  // namespace stiction::track
