// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/measure/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "benchmarks/track/measure/child.h"
#include "benchmarks/track/measure/google_json.h"
#include "benchmarks/track/store/scratch.h"
#include "reference/process/processors.h"
#include "reference/statistics/two_samples.h"
#include "reports/screen/progress_line.h"

namespace stiction::track {

namespace {

namespace fs = std::filesystem;

std::string exactly_these(const std::vector<std::string>& names) {
  std::string pattern;
  for (const std::string& name : names) {
    pattern += pattern.empty() ? "^(" : "|";
    for (const char sign : name) {
      if (std::string(".[]{}()*+?^$|\\").find(sign) != std::string::npos) pattern += '\\';
      pattern += sign;
    }
  }
  return pattern + ")$";
}

// Those whose noise is above what is wanted.
std::vector<std::string> noisy(const Measurements& measured, const std::vector<std::string>& names,
                               double wanted) {
  std::vector<std::string> found;
  for (const std::string& name : names) {
    const Measurement* const one = measured.find(Metric{name, "time", "s", Kind::kTime}.name());
    if (reference::split_half_noise(one->samples, 0.95, 1) > wanted) found.push_back(name);
  }
  return found;
}

}  // namespace

void time_once(const Tree& tree, const std::vector<std::string>& names, const TimingPlan& plan,
               Measurements& measured) {
  const std::string what = fmt::format("{} cannot be timed", tree.label);
  const Scratch scratch;
  const fs::path out = scratch.folder() / "times.json";
  const Ended ended =
      run({tree.program("bench").string(), "--benchmark_filter=" + exactly_these(names),
           "--benchmark_out=" + out.string(), "--benchmark_out_format=json",
           fmt::format("--benchmark_min_time={}", plan.seconds),
           fmt::format("--benchmark_repetitions={}", plan.repetitions)},
          scratch.folder());
  const std::string text = content_of(out);
  if (text.empty() || ended.code != 0) throw TrackError(what + ": " + last_line(ended.errors));
  std::map<std::string, double> fastest;
  for (const GoogleResult& result : read_google_results(text, what)) {
    const auto [place, is_new] = fastest.emplace(result.name, result.seconds);
    if (!is_new) place->second = std::min(place->second, result.seconds);
  }
  for (const std::string& name : names) {
    const auto found = fastest.find(name);
    if (found == fastest.end()) throw TrackError(fmt::format("{}: it has no {}", what, name));
    measured.add({name, "time", "s", Kind::kTime}, found->second);
  }
}

void time_in_turn(const Tree& a, const Tree& b, const std::vector<std::string>& names,
                  const TimingPlan& plan, Measurements& of_a, Measurements& of_b) {
  ProgressLine progress(static_cast<std::size_t>(plan.most_rounds));
  std::vector<std::string> wanted = names;
  for (int round = 0; round < std::max(plan.least_rounds, plan.most_rounds); ++round) {
    if (round >= plan.least_rounds) {
      std::vector<std::string> still = noisy(of_a, wanted, plan.wanted_floor);
      for (const std::string& name : noisy(of_b, wanted, plan.wanted_floor)) {
        if (std::find(still.begin(), still.end(), name) == still.end()) still.push_back(name);
      }
      wanted = still;
    }
    if (wanted.empty()) break;
    progress.show(static_cast<std::size_t>(round),
                  fmt::format("times of {} benchmarks, in turn", wanted.size()));
    const reference::OnFastestProcessor here;  // both of a round
    const bool a_first = round % 2 == 0;
    time_once(a_first ? a : b, wanted, plan, a_first ? of_a : of_b);
    time_once(a_first ? b : a, wanted, plan, a_first ? of_b : of_a);
  }
}

}  // namespace stiction::track
