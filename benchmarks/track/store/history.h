// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/track/decide/metric.h"
#include "benchmarks/track/store/history_file.h"

namespace stiction::track {

/// What a measurement depends on besides the revision. Only runs of equal machines are compared.
struct Machine {
  std::string processor{};  ///< model name
  std::int64_t cores = 0;
  std::string compiler{};
  std::string flags{};  ///< build type and flags that matter

  bool operator==(const Machine&) const = default;
  std::string text() const;  ///< one line for people
};

/// What differs between two machines, e.g. "compiler: GCC 12.2.0 / GCC 13.1.0"; empty when equal.
std::string difference(const Machine& a, const Machine& b);

/// All that was measured of one revision on one machine, at one time.
struct StoredRun {
  std::int64_t id = 0;     ///< given by the history
  std::string date{};      ///< UTC, ISO 8601
  std::string revision{};  ///< 12 hex digits, "+" behind it when files were changed
  std::string label{};     ///< what it was measured as: "present", "HEAD~1", a file's name
  Machine machine{};
  Measurements measurements{};
};

/// A metric over the runs of one machine, oldest first: the median of each run.
struct Trend {
  Metric metric;
  std::vector<std::int64_t> runs;  ///< ids
  std::vector<double> medians;     ///< as many, in the metric's unit
};

/// The store of runs: one SQLite file (benchmarks/schema.md). A run is written in one transaction
/// that is on disk when `add` returns: after a crash the file opens and holds each finished run
/// whole. Many programs may read and write it at a time; a writer waits for another, up to a
/// minute. Failures are TrackError with the file's name.
class History {
 public:
  /// As open_history does (history_file.h).
  explicit History(const std::filesystem::path& file, Access access = Access::kWrite);

  /// Gives its id. Throws TrackError, besides what SQLite says, for a metric that the history knows in
  /// another unit or as another kind.
  std::int64_t add(const StoredRun& run);

  /// How many runs this program has added so far.
  static int added();

  /// Runs without their measurements, oldest first; of one machine, or of all.
  std::vector<StoredRun> runs(const std::optional<Machine>& machine) const;

  /// One run with its measurements. Throws TrackError when there is none of this id.
  StoredRun run(std::int64_t id) const;

  /// Names of all metrics that were ever measured, in order.
  std::vector<std::string> metrics() const;

  /// Metrics whose name matches the glob (all when it is empty), by name.
  std::vector<Trend> trends(const std::string& glob, const std::optional<Machine>& machine) const;

 private:
  std::int64_t id_of(const Machine& machine);
  std::int64_t id_of(const Metric& metric);

  SQLite::Database database_;
};

}  // namespace stiction::track
