// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "benchmarks/bench/features.h"
#include "benchmarks/bench/machine_peak.h"
#include "benchmarks/bench/scaling.h"

namespace stiction::bench {

/// One line a benchmark on the terminal: time, model and what part of the machine that is.
class Console final : public benchmark::BenchmarkReporter {
 public:
  explicit Console(const MachinePeak& machine) : machine_(machine) {}
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;

 private:
  MachinePeak machine_;
};

/// Google Benchmark's own JSON, with the names as they were registered (it would add
/// "/manual_time").
class JsonFile final : public benchmark::JSONReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override;
};

void print(const std::vector<Scaling>& scalings);
void print(const std::vector<FeatureCost>& features);

}  // namespace stiction::bench
