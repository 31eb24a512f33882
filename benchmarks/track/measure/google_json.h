// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/track/store/history.h"

namespace stiction::track {

/// One repetition of a benchmark in Google Benchmark's JSON.
struct GoogleResult {
  std::string name;      ///< run_name
  double seconds = 0.0;  ///< CPU time: per contact where the counter `time_per_contact` is there,
                         ///< else per iteration, s
};

/// Repetitions in the order of the text; aggregates (mean, median, …) are left out.
/// Throws TrackError "<what>: …" for text that is not Google Benchmark's JSON, and for a benchmark
/// that reports an error of its own.
std::vector<GoogleResult> read_google_results(const std::string& text, const std::string& what);

/// A run of the history from such a file of any program: machine and date from its context. From one that
/// `to_google_json` wrote, that run, to the last bit, without its id. Throws TrackError for what is not
/// such a file.
StoredRun run_from_google_json(const std::string& text, const std::string& what);

/// The same way back: times as repetitions in nanoseconds, what else was measured of their subject as
/// counters, and all of the run once more in an object of our own (benchmarks/schema.md).
std::string to_google_json(const StoredRun& run);

}  // namespace stiction::track
