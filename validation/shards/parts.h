// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reports/record/record.h"
#include "validation/shards/run_plan.h"

namespace stiction {

/// The finished records of a run's parts, by job: of a job that stands twice one that did not break off,
/// and then that of the newest part.
/// They stay on disk; what is held of each is its place.
class Parts {
 public:
  /// Of all runs in these folders, as deep as they lie ('latest' and other links are not followed). Throws
  /// InputError where there is no run, or parts of several; std::runtime_error for a file that holds
  /// what is none.
  explicit Parts(const std::vector<std::string>& folders);

  const RunPlan& plan() const { return plan_; }
  /// What is missing, in a sentence that names the parts: empty when every job has a record.
  std::string missing() const;
  /// The record of a job. Throws std::runtime_error for one that is missing.
  Record record(std::size_t job) const;
  /// The folder of the part that computed it.
  const std::filesystem::path& folder(std::size_t job) const;
  /// Those of all parts.
  const std::vector<std::filesystem::path>& folders() const { return folders_; }

 private:
  struct Place {
    std::uint32_t part = 0;
    bool broke = false;
    std::uint64_t offset = 0;
  };
  void take(std::uint32_t part);
  const Place& place(std::size_t job) const;

  RunPlan plan_{};
  std::vector<std::filesystem::path> folders_{};  // newest first
  std::vector<Shard> shards_{};                   // of the folders
  std::vector<std::optional<Place>> places_{};    // of the jobs
};

/// Copies a record's recording from the folder of its part into that of the run that takes it over.
void take_recording(const Record& record, const std::filesystem::path& from,
                    const std::filesystem::path& to);

}  // namespace stiction
