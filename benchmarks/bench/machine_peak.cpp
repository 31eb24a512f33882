// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/machine_peak.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <vector>

#include "benchmarks/bench/in_turn.h"
#include "validation/engine/cpu_time.h"

namespace stiction::bench {

namespace {

// 3 × 64 MiB, beyond the last-level cache of a desktop.
class Triad {
 public:
  static constexpr std::size_t kCount = std::size_t{8} << 20;
  // Two reads, one write, and the read of the line that is written.
  static constexpr double kBytes = 4.0 * 8.0 * kCount;

  void run(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) a_[i] = b_[i] + 0.5 * c_[i];
    benchmark::DoNotOptimize(a_.data());
    benchmark::ClobberMemory();
  }

 private:
  std::vector<double> a_ = std::vector<double>(kCount, 0.0), b_ = std::vector<double>(kCount, 1.0),
                      c_ = std::vector<double>(kCount, 2.0);
};

// As many chains as fit into sixteen registers of two doubles beside the two constants.
constexpr std::size_t kChains = 28;
constexpr int kRounds = 1 << 20;
void run_chains() {
  std::array<double, kChains> x;
  x.fill(1.0);
  double a = 0.999999, b = 1e-6;
  benchmark::DoNotOptimize(a);
  benchmark::DoNotOptimize(b);
  for (int round = 0; round < kRounds; ++round) {
    for (double& value : x) value = a * value + b;
  }
  benchmark::DoNotOptimize(x);
}

// The least CPU time of several runs, s.
template <class Work>
double least_seconds(const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 5; ++k) {
    const double start = thread_cpu_seconds();
    work();
    least = std::min(least, thread_cpu_seconds() - start);
  }
  return least;
}

}  // namespace

double clock_overhead() {
  double smallest = 1.0;
  for (int k = 0; k < 1000; ++k) {
    const double start = thread_cpu_seconds();
    smallest = std::min(smallest, thread_cpu_seconds() - start);
  }
  return smallest;
}

MachinePeak measure_peak() {
  Triad triad;
  return {Triad::kBytes / least_seconds([&] { triad.run(0, Triad::kCount); }),
          2.0 * kChains * kRounds / least_seconds(run_chains)};
}

double memory_gain(const Team& team) {
  Triad triad;
  const auto count = static_cast<std::size_t>(team.size());
  const auto seconds_with = [&](const Team* with) {
    const auto start = std::chrono::steady_clock::now();
    for_each(with, count, [&](std::size_t k) {
      triad.run(Triad::kCount * k / count, Triad::kCount * (k + 1) / count);
    });
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  seconds_with(&team);  // wakes the threads
  const auto alone = [&] { return seconds_with(nullptr); };
  const auto together = [&] { return seconds_with(&team); };
  return ratio_in_turn(alone, together).median;
}

}  // namespace stiction::bench
