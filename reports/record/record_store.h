// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

#include "reports/record/record.h"

namespace stiction {

/// For programs that make something of a run: writes its folder to the file that the environment
/// variable STICTION_RUN_FILE names, where ./stiction looks; nothing without it.
void tell_run_folder(const std::filesystem::path& folder);

/// The folder of one run. Each run has its own, so that two runs into one `out_dir` never mix:
///
///   out_dir/2025-11-20T23-41-05Z/records.jsonl   one line a record, written as soon as it is known
///   out_dir/2025-11-20T23-41-05Z/report.md …     written at the end
///   out_dir/latest                               symlink to the last finished run
///
/// Invariant: between two calls records.jsonl consists of complete lines, whatever failed. (A crash
/// within a call can leave one cut-off last line, which read_records reports.)
///
/// Failures of the system are std::runtime_error with one sentence that names the file and the
/// cause. A program that may meet a file size limit ignores SIGXFSZ, else the system ends it at the
/// first such write.
class RecordStore {
 public:
  /// Makes `out_dir` where it is missing and in it a folder named by the UTC time to the second,
  /// with "-2", "-3" … behind it while that name is taken. What stands at `out_dir/latest` and is no
  /// link is refused, so that no run is made in vain.
  static RecordStore create(const std::filesystem::path& out_dir);

  ~RecordStore();
  RecordStore(const RecordStore&) = delete;
  RecordStore& operator=(const RecordStore&) = delete;

  /// Adds one line to records.jsonl and waits until it is on disk (wait_for_disk_every). Safe to call from many threads.
  /// On failure the file holds the records of the earlier calls, and later calls may succeed.
  /// Throws std::invalid_argument for a record that could not be read back (record_json.h).
  void append(const Record& record);

  /// From now on append waits for the disk no more often than that, for runs of thousands of short
  /// records: what kills the program costs no record, a power cut those of the last `seconds`.
  void wait_for_disk_every(double seconds) { wait_every_ = seconds; }

  /// Writes a file of the run (report.md, junit.xml, …): completely or not at all; an older one of
  /// the same name stays until then. `name` is a plain file name.
  void write_file(const std::string& name, std::string_view content);

  /// Points `out_dir/latest` at this run in one step: a reader sees the old or the new target.
  void finish();

  /// For a program that is ended in the middle of its run: waits for the write in progress, lets no other
  /// begin, and says where the finished records are; a run without any is removed.
  std::string last_words();

  /// tell_run_folder of this run.
  void tell_caller() const;

  /// The run's folder and its records file, absolute.
  const std::filesystem::path& folder() const { return folder_; }
  const std::filesystem::path& records_file() const { return records_file_; }

 private:
  RecordStore(std::filesystem::path folder, std::filesystem::path records_file, int descriptor);

  // Cuts what a failed write left behind. Returns whether the file is whole again.
  bool cut_back();

  std::filesystem::path folder_;
  std::filesystem::path records_file_;
  int descriptor_;                    // of records.jsonl, O_APPEND
  std::mutex mutex_;                  // guards what follows and the writes
  std::uint64_t complete_bytes_ = 0;  // of records.jsonl, up to the last complete line
  std::uint64_t complete_records_ = 0;
  std::set<std::filesystem::path> files_{};         // that write_file wrote
  double wait_every_ = 0.0;                         // s
  std::chrono::steady_clock::time_point waited_{};  // for the disk, last
  bool torn_ = false;  // bytes behind complete_bytes_ could not be cut yet
};

}  // namespace stiction
