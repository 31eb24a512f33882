// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/record/record.h"
#include "reports/recording/frames.h"
#include "validation/core/case.h"

namespace stiction {

/// A case with the engine and settings it shall run with.
struct Job {
  Case which;
  EngineKind engine;
  Settings settings;
  /// CPU time of all its steps, s: what takes longer is an error that says so.
  double cpu_limit = std::numeric_limits<double>::infinity();
  int finer = 1;  ///< its time steps are 1/finer of those that it takes else
};

/// * and ? as in a shell, * also across '/'.
bool matches(const std::string& glob, const std::string& name);

/// Which cases to run, and how.
struct Selection {
  std::vector<std::string> globs{};  ///< of case names (matches); empty: all
  CaseSet set = CaseSet::kDefault;
  std::string suite{};  ///< as in Case; a glob chooses from all
  std::string engine = "stiction";
  Settings settings{};          ///< over those of each variant
  std::string perturbation{};   ///< by name (stability/perturbation.h); empty: none
  std::string configuration{};  ///< of the engine, by name; empty: all that it runs a case with
};

/// Jobs of the cases chosen, in the catalog's order; variants that the user's settings make equal
/// run once. A case named by a glob runs whatever set and suite it belongs to. Throws InputError when
/// a glob matches no case, suite or engine are unknown, or no case chosen runs in the configuration.
std::vector<Job> select_jobs(const std::vector<Case>& cases, const Selection& selection);

/// Runs one job. What goes wrong becomes the record's error; nothing is thrown for it. What the
/// case recorded for the player goes into `recording`; without one nothing is recorded.
Record run_job(const Job& job, double tolerance_scale,
               std::optional<Recording>* recording = nullptr);

/// Calls `work(k)` for k = 0 … count − 1 on `threads` threads, begun in that order; when one throws, no
/// further one begins and the exception leaves this function.
void run_numbered(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

/// Keeps the recording of the job with this index; gives the record's `frames`.
using KeepRecording = std::function<std::string(std::size_t, const Recording&)>;

/// Runs jobs on `threads` threads, each job on one, begun in `order`: indices, each once.
/// `finished(index, record)` is called once a job, from any thread, one call at a time, and `keep` just
/// before it when the case recorded something; when one throws, no further job starts and the exception
/// leaves this function. Without `keep` nothing is recorded.
void run_jobs(const std::vector<Job>& jobs, std::span<const std::size_t> order, int threads,
              double tolerance_scale, const std::function<void(std::size_t, Record)>& finished,
              const KeepRecording& keep = {});

}  // namespace stiction
