// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/measure.h"

#include <algorithm>
#include <optional>
#include <regex>

#include "benchmarks/bench/in_turn.h"
#include "reference/process/processors.h"
#include "reference/statistics/two_samples.h"
#include "solver/demand.h"
#include "validation/engine/cpu_time.h"

namespace stiction::bench {

std::vector<Chosen> choose(const std::string& filter, bool full) {
  const bool without = !filter.empty() && filter[0] == '-';
  std::regex wanted;
  try {
    wanted = std::regex(without ? filter.substr(1) : filter, std::regex::extended);
  } catch (const std::regex_error&) {
    throw InputError("--benchmark_filter: '" + filter + "' is no regular expression");
  }
  std::vector<Chosen> chosen;
  for (const WorkloadFamily& family : family_catalog()) {
    std::vector<int> sizes = family.sizes;
    if (full) sizes.insert(sizes.end(), family.full_sizes.begin(), family.full_sizes.end());
    for (const int size : sizes) {
      for (const Timed& timed : timed_parts()) {
        if (!family.two_sided && (timed.phase == Phase::kDepth || timed.afresh)) continue;
        const std::string name = benchmark_name(timed, family.name, size);
        if (!filter.empty() && std::regex_search(name, wanted) == without) continue;
        chosen.push_back({timed, family, size, name});
      }
    }
  }
  if (chosen.empty()) throw InputError("no benchmark matches '" + filter + "'");
  return chosen;
}

namespace {

// What takes long is done once by Google Benchmark; a batch of what goes on is a mean of many steps already.
constexpr std::size_t kFewest = 5;

SpeedUp speed_up_of(Batch& batch, const Team& team) {
  SpeedUp found{.threads = team.size()};
  batch.time(&team);  // wakes the threads, and allocates
  std::uint64_t hash = 0;
  const auto alone = [&] {
    const double seconds = batch.time().wall;
    hash = batch.hash();
    return seconds;
  };
  const auto together = [&] {
    const double seconds = batch.time(&team).wall;
    found.same_hash = found.same_hash && batch.hash() == hash;
    return seconds;
  };
  found.together[0] = reference::measure_together(team.size());
  found.ratio = ratio_in_turn(alone, together);
  found.together[1] = reference::measure_together(team.size());
  return found;
}

}  // namespace

void Measure::run(benchmark::State& state, const Chosen& chosen) {
  // Chosen anew for each benchmark: which one is the fastest changes within minutes.
  std::optional<reference::OnFastestProcessor> here;
  if (team_ == nullptr) here.emplace();
  Batch& batch = batch_of(chosen);
  std::vector<double> seconds;
  seconds.reserve(static_cast<std::size_t>(state.max_iterations));
  const auto add = [&] {
    const double of_batch = std::max(1e-9, batch.time().cpu - overhead_);
    seconds.push_back(of_batch / batch.steps());
    return of_batch;
  };
  while (state.KeepRunningBatch(batch.steps())) state.SetIterationTime(add());
  while (batch.steps() == 1 && seconds.size() < kFewest) add();
  Result result{chosen,
                static_cast<double>(batch.work().contacts()),
                reference::median(std::move(seconds)),
                modelled_cost(chosen.timed, batch.work()),
                batch.hash(),
                batch.work().error(),
                {}};
  if (team_ != nullptr) result.speed_up = speed_up_of(batch, *team_);
  state.counters["contacts"] = result.contacts;
  state.counters["time_per_contact"] = result.seconds / result.contacts;
  // 32 bits of it, which a double holds exactly.
  state.counters["hash"] = static_cast<double>(result.hash & 0xffffffffu);
  state.counters["error"] = result.error;
  state.counters["bytes_per_contact"] = result.cost.bytes / result.contacts;
  state.counters["flops_per_contact"] = result.cost.flops / result.contacts;
  state.counters["of_bandwidth"] = result.cost.bytes / result.seconds / machine_.bytes_per_second;
  state.counters["of_peak"] = result.cost.flops / result.seconds / machine_.flops_per_second;
  keep(std::move(result));
}

Batch& Measure::batch_of(const Chosen& chosen) {
  if (batch_ && batch_name_ == chosen.name) return *batch_;
  batch_.reset();
  if (!workload_ || workload_->family != chosen.family.name || workload_->size != chosen.size) {
    finish();
    const double start = thread_cpu_seconds();
    workload_ = std::make_unique<Workload>(settle(chosen.family, chosen.size));
    settled_.push_back({chosen.family.name, chosen.size, static_cast<double>(workload_->contacts()),
                        workload_->options, workload_->checks, hash_of(workload_->state),
                        workload_->state.step, workload_->workspace.contact_updates,
                        thread_cpu_seconds() - start});
  }
  batch_ = std::make_unique<Batch>(*workload_, chosen.timed);
  batch_->warm();
  batch_name_ = chosen.name;
  return *batch_;
}

void Measure::finish() {
  if (workload_ && done_) done_(settled_.back());
  batch_.reset();
  workload_.reset();
}

void Measure::keep(Result result) {
  const auto at = std::find_if(results_.begin(), results_.end(), [&](const Result& known) {
    return known.chosen.name == result.chosen.name;
  });
  if (at == results_.end()) {
    results_.push_back(std::move(result));
  } else if (result.seconds < at->seconds) {
    *at = std::move(result);
  }
}

}  // namespace stiction::bench
