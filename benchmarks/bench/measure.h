// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/bench/batch.h"
#include "benchmarks/bench/cost_model.h"
#include "benchmarks/bench/machine_peak.h"
#include "reference/process/processors.h"
#include "reference/statistics/two_samples.h"
#include "solver/parallel/team.h"

namespace stiction::bench {

/// A benchmark that was chosen to run.
struct Chosen {
  Timed timed;
  WorkloadFamily family;
  int size = 0;  ///< contacts asked for
  std::string name;
};

/// How much faster threads do the same batches, which they do in turn with one alone.
struct SpeedUp {
  int threads = 1;
  reference::Quartiles ratio{};          ///< of the wall-clock times, dimensionless
  bool same_hash = true;                 ///< both have written the same bits
  reference::Together together[2] = {};  ///< before and after
};

/// What was measured of one.
struct Result {
  Chosen chosen;
  double contacts = 0.0;
  double seconds = 0.0;  ///< CPU time of the part in a step, median over batches
  ModelledCost cost;     ///< of it, by the model
  std::uint64_t hash = 0;
  double error = 0.0;  ///< of the workload with the part's friction rule, dimensionless
  std::optional<SpeedUp> speed_up;  ///< with --threads
};

/// All benchmarks, or those whose name holds a match of the regular expression (not those, when it
/// begins with '-'), family by family and size by size. Throws InputError when there is none, or
/// when it is no regular expression.
std::vector<Chosen> choose(const std::string& filter, bool full);

/// Runs benchmarks for Google Benchmark and keeps what they measured. Of workloads and batches it
/// holds only the last, so order them by workload.
class Measure {
 public:
  /// One settled workload a family and size, without its arrays: for the records.
  struct Settled {
    std::string family;
    int size = 0;
    double contacts = 0.0;
    Options options;
    std::vector<Judgement> checks;
    std::uint64_t hash = 0;
    std::uint64_t steps = 0;
    std::uint64_t contact_updates = 0;
    double seconds = 0.0;  ///< CPU time of the settling
  };

  /// Each part is measured on one thread, and with a team of more beside it if there is one.
  explicit Measure(const MachinePeak& machine, const Team* team = nullptr)
      : machine_(machine), team_(team), overhead_(clock_overhead()) {}

  void run(benchmark::State& state, const Chosen& chosen);

  /// What is called of each workload once another one is run; of the last by finish().
  void when_done(std::function<void(const Settled&)> done) { done_ = std::move(done); }
  void finish();

  /// In the order of the first run; of repetitions the fastest.
  const std::vector<Result>& results() const { return results_; }
  const std::vector<Settled>& settled() const { return settled_; }

 private:
  Batch& batch_of(const Chosen& chosen);
  void keep(Result result);

  MachinePeak machine_;
  const Team* team_;
  double overhead_;
  std::unique_ptr<Workload> workload_;
  std::unique_ptr<Batch> batch_;
  std::string batch_name_;
  std::vector<Settled> settled_;
  std::function<void(const Settled&)> done_;
  std::vector<Result> results_;
};

}  // namespace stiction::bench
