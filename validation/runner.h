// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reports/record.h"
#include "validation/case.h"

namespace stiction {

/// A case with the engine and settings it shall run with.
struct Job {
  Case which;
  EngineKind engine;
  Settings settings;
};

/// Which cases to run, and how.
struct Selection {
  std::vector<std::string>
      globs{};  ///< case names, * and ? as in a shell, * also across '/'; empty: all
  CaseSet set = CaseSet::kDefault;
  std::string engine = "stiction";
  Settings settings{};  ///< over those of each variant
};

/// Jobs of the cases chosen, in the catalog's order; variants that the user's settings make equal
/// run once. A case named by a glob runs whatever set it belongs to. Throws InputError when a glob
/// matches no case or the engine is unknown.
std::vector<Job> select_jobs(const std::vector<Case>& cases, const Selection& selection);

/// Runs one job. What goes wrong becomes the record's error; nothing is thrown for it.
Record run_job(const Job& job, double tolerance_scale);

/// Runs the jobs on `threads` threads, each job on one. `finished(index, record)` is called once a
/// job, from any thread, one call at a time; when it throws, no further job starts and the
/// exception leaves this function.
void run_jobs(const std::vector<Job>& jobs, int threads, double tolerance_scale,
              const std::function<void(std::size_t, Record)>& finished);

}  // namespace stiction
