// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/record/record.h"
#include "reports/screen/progress_line.h"
#include "reports/screen/screen.h"
#include "validation/core/runner.h"

namespace stiction {

/// What a console is told by.
struct ConsoleOptions {
  bool verbose = false;  ///< all records, not only what fails
  bool quiet = false;    ///< nothing but errors and the line of progress
  std::filesystem::path
      earlier{};  ///< records of an earlier run, for the time to go; may be missing
  std::function<std::string(const Record&)>
      rerun{};  ///< the command that runs a record's case again
};

/// What is seen while jobs run: a line of progress, what fails as soon as it is known, and when
/// verbose all records, in the order of their jobs.
class Console {
 public:
  /// `jobs` must outlive it.
  Console(const std::vector<Job>& jobs, const Screen& screen, ConsoleOptions options);

  /// Of the job at `index`, in any order.
  void finished(std::size_t index, const Record& record);

 private:
  void show_progress();

  ConsoleOptions options_;
  Screen screen_;
  const std::vector<Job>& jobs_;
  std::vector<double> weights_;  // of the jobs, and their sum
  double total_;
  double work_done_ = 0.0;
  std::size_t count_done_ = 0;
  std::vector<std::optional<std::string>> waiting_;
  std::size_t next_ = 0;
  ProgressLine progress_;
};

}  // namespace stiction
