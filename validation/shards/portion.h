// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/record/record_store.h"
#include "validation/core/runner.h"
#include "validation/shards/job_costs.h"
#include "validation/shards/parts.h"
#include "validation/shards/run_plan.h"

namespace stiction {

/// What a person says of it on the command line, and what that line was.
struct PortionWords {
  std::string shard{};               ///< as shard_from reads it
  std::vector<std::string> parts{};  ///< folders whose finished records are taken instead
  std::vector<std::string> command{};
};

/// The parts that the words name, which must be all of the run that `plan` is of; none where they name
/// none. Throws InputError.
std::optional<Parts> parts_of(const RunPlan& plan, const PortionWords& words);

/// "part 2 of 8, 19 of 152 jobs"; `what` are "jobs" or "points".
std::string part_text(const Shard& shard, std::size_t own, std::size_t all, const char* what);

/// The jobs of a run that one process computes: all, those of a shard, or none, where the parts of the
/// run are put together.
class Portion {
 public:
  /// `depends` tells files and options that results depend on beside the jobs. Throws InputError for
  /// words that are no shard, and for parts of another run or not whole.
  Portion(const std::string& program, const std::vector<Job>& all, Together together,
          const PortionWords& words, const std::string& depends = "");

  const std::vector<Job>& jobs() const { return jobs_; }
  /// The place of one of them among all.
  std::size_t number(std::size_t job) const { return numbers_[job]; }
  bool is_whole() const { return plan_.shard.count == 1; }
  /// part_text; empty for the whole.
  std::string text() const;

  /// run_jobs of these into the store, whose run.json it writes first; or what is taken from parts, with
  /// its recordings, in order.
  void run(RecordStore& store, int threads, double tolerance_scale,
           const std::function<void(std::size_t, Record)>& finished,
           const KeepRecording& keep = {}) const;
  /// Of a part that has no tables, as those set side by side what other parts have: says on standard
  /// error where its records are.
  void finish_part(RecordStore& store) const;

 private:
  RunPlan plan_;
  std::optional<Parts> parts_{};
  std::vector<std::size_t> numbers_{};
  std::vector<Job> jobs_{};
};

}  // namespace stiction
