// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/sizes/sizes.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <memory>

#include "benchmarks/track/measure/child.h"
#include "reference/process/processors.h"

namespace stiction::track {

namespace {

// Turns of one start; quartiles of five are three of their values. Where the memory of a process happens to lie
// is part of its times (10 000 contacts: up to a fifth, measured), so all are started anew while there is time.
constexpr std::size_t kTurns = 5, kMostStarts = 5;
constexpr double kStartsSeconds = 30.0;

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void add(const Yardstick::Steps& steps, StepTimes& times) {
  times.cpu.push_back(steps.cpu);
  times.wall.push_back(steps.wall);
  for (const auto& [phase, seconds] : steps.phases) times.phases[phase].push_back(seconds);
  if (times.cpu.size() == 1) times.hash = steps.hash;
  if (times.hash != steps.hash) times.hash.clear();
}

double per_contact(const std::vector<double>& seconds, const StepTimes& times) {
  return 1e9 * reference::median(seconds) / std::max(1.0, times.settled.contacts);
}

// Turn by turn.
std::vector<double> ratios(const StepTimes& one, const StepTimes& other, bool by_wall) {
  const std::vector<double>& a = by_wall ? one.wall : one.cpu;
  const std::vector<double>& b = by_wall ? other.wall : other.cpu;
  std::vector<double> all;
  for (std::size_t k = 0; k < a.size(); ++k) {
    all.push_back(a[k] / b[k] * (other.settled.contacts / one.settled.contacts));
  }
  return all;
}

bool wanted(const Workload& workload, const std::vector<std::string>& globs) {
  return globs.empty() || std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) {
           return fnmatch(glob.c_str(), workload.name().c_str(), 0) == 0;
         });
}

}  // namespace

double step_nanoseconds(const StepTimes& times) { return per_contact(times.cpu, times); }

double wall_nanoseconds(const StepTimes& times) { return per_contact(times.wall, times); }

double phase_nanoseconds(const StepTimes& times, const std::vector<std::string>& phases) {
  double sum = 0.0;
  for (const std::string& phase : phases) {
    const auto at = times.phases.find(phase);
    if (at != times.phases.end()) sum += per_contact(at->second, times);
  }
  return sum;
}

reference::Quartiles ratio(const StepTimes& one, const StepTimes& other, bool by_wall) {
  return reference::quartiles(ratios(one, other, by_wall));
}

double ratio_near(const SizeResult& result, const StepTimes& one, const StepTimes& other) {
  constexpr std::size_t kFewest = 3;
  const std::vector<double> all = ratios(one, other, true);
  std::vector<double> near;
  for (std::size_t k = 0; k < std::min(all.size(), result.together.size()); ++k) {
    const auto [least, most] =
        std::minmax(result.together[k][0].answer_seconds, result.together[k][1].answer_seconds);
    if (least > 0.0 && most < kNear) near.push_back(all[k]);  // 0: there is one alone
  }
  return near.size() < kFewest ? std::nan("") : reference::median(std::move(near));
}

std::vector<Way> ways_of(const Tree& before, const Tree& now, int threads) {
  const std::string yardstick = now.program("yardstick").string();
  std::vector<Way> ways = {{"before", before.program("present_yardstick").string()},
                           {"now", yardstick}};
  std::vector<int> widths = widths_of(yardstick);
  if (!widths.empty()) widths.pop_back();  // which it takes by itself
  for (const int width : widths) {
    ways.push_back({fmt::format("registers of {}", width), yardstick, width});
  }
  if (threads > 1) ways.push_back({fmt::format("{} threads", threads), yardstick, 0, threads});
  return ways;
}

std::vector<Workload> workloads_of(const Tree& now, const std::vector<std::string>& globs,
                                   bool full) {
  std::vector<Workload> chosen;
  for (const Workload& one : workloads_of(now.program("yardstick").string())) {
    if (wanted(one, globs) && (full || !one.is_long)) chosen.push_back(one);
  }
  if (chosen.empty()) throw TrackError("there is no workload of this name");
  return chosen;
}

namespace {

// Starts all, which settle side by side, and has them take turns.
void add_turns(SizeResult& result) {
  std::vector<std::unique_ptr<Yardstick>> yardsticks;
  std::vector<std::future<Yardstick::Settled>> settled;
  for (const Way& way : result.ways) {
    yardsticks.push_back(std::make_unique<Yardstick>(way, result.workload));
  }
  for (const std::unique_ptr<Yardstick>& one : yardsticks) {
    settled.push_back(std::async(std::launch::async, [&one] { return one->settle(); }));
  }
  for (std::size_t k = 0; k < settled.size(); ++k) result.times[k].settled = settled[k].get();
  result.limits = yardsticks[1]->limits();
  for (const std::unique_ptr<Yardstick>& one : yardsticks) one->steps();  // allocates
  for (std::size_t turn = 0; turn < kTurns; ++turn) {
    // All of a turn are timed on the same processor; others that help stay where the system has them.
    const int fastest = reference::fastest_processor();
    for (const std::unique_ptr<Yardstick>& one : yardsticks) {
      if (fastest >= 0) one->stay_on(fastest);
    }
    for (std::size_t k = 0; k < yardsticks.size(); ++k) {
      const std::size_t at = turn % 2 == 0 ? k : yardsticks.size() - 1 - k;
      const int threads = result.ways[at].threads;
      if (threads == 1) {
        add(yardsticks[at]->steps(), result.times[at]);
        continue;
      }
      const reference::Together before = reference::measure_together(threads);
      add(yardsticks[at]->steps(), result.times[at]);
      result.together.push_back({before, reference::measure_together(threads)});
    }
  }
}

}  // namespace

SizeResult measure_size(const Workload& workload, const std::vector<Way>& ways) {
  SizeResult result{.workload = workload, .ways = ways, .times = {}, .limits = {}, .together = {}};
  result.times.resize(ways.size());
  const double begun = seconds_now();
  for (std::size_t start = 0; start < kMostStarts; ++start) {
    if (start > 0 && seconds_now() - begun > kStartsSeconds) break;
    add_turns(result);
  }
  return result;
}

}  // namespace stiction::track
