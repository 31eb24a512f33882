// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/machine_peak.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <vector>

#include "validation/engine/cpu_time.h"

namespace stiction::bench {

namespace {

double bandwidth() {
  // 3 × 64 MiB, beyond the last-level cache of a desktop.
  constexpr std::size_t kCount = std::size_t{8} << 20;
  std::vector<double> a(kCount, 0.0), b(kCount, 1.0), c(kCount, 2.0);
  double best = 0.0;
  for (int k = 0; k < 5; ++k) {
    const double start = thread_cpu_seconds();
    for (std::size_t i = 0; i < kCount; ++i) a[i] = b[i] + 0.5 * c[i];
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
    // Two reads, one write, and the read of the line that is written.
    best = std::max(best, 4.0 * 8.0 * static_cast<double>(kCount) / (thread_cpu_seconds() - start));
  }
  return best;
}

double peak() {
  // As many chains as fit into sixteen registers of two doubles beside the two constants.
  constexpr std::size_t kChains = 28;
  constexpr int kRounds = 1 << 20;
  double best = 0.0;
  for (int k = 0; k < 5; ++k) {
    std::array<double, kChains> x;
    x.fill(1.0);
    double a = 0.999999, b = 1e-6;
    benchmark::DoNotOptimize(a);
    benchmark::DoNotOptimize(b);
    const double start = thread_cpu_seconds();
    for (int round = 0; round < kRounds; ++round) {
      for (double& value : x) value = a * value + b;
    }
    benchmark::DoNotOptimize(x);
    best = std::max(best, 2.0 * kChains * kRounds / (thread_cpu_seconds() - start));
  }
  return best;
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

MachinePeak measure_peak() { return {bandwidth(), peak()}; }

}  // namespace stiction::bench
