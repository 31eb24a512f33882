// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <benchmark/benchmark.h>

#include <sstream>
#include <string>
#include <vector>

#include "benchmarks/bench/features.h"
#include "benchmarks/bench/machine_peak.h"
#include "benchmarks/bench/scaling.h"
#include "reports/screen/progress_line.h"

namespace stiction::bench {

/// One line a benchmark: time, model and what part of the machine that is. They are kept as text, and
/// printed as they come with `verbose`; a terminal sees what runs.
class Console final : public benchmark::BenchmarkReporter {
 public:
  /// `names`: of the benchmarks, in their order; `further` pieces of work come behind them.
  Console(const MachinePeak& machine, std::vector<std::string> names, std::size_t further,
          bool verbose);
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;
  /// Work behind the benchmarks begins.
  void next(const std::string& what) { progress_.show(done_++, what); }
  /// More lines of the same text.
  void add(const std::string& lines);
  void finished() { progress_.clear(); }
  const std::string& text() const { return text_; }

 private:
  MachinePeak machine_;
  std::vector<std::string> names_;
  bool verbose_;
  std::size_t done_ = 0;
  std::string text_, last_;
  ProgressLine progress_;
};

/// Google Benchmark's own JSON, with the names as they were registered (it would add
/// "/manual_time"). It is kept as text, whatever the stream that it is given: Google Benchmark does not look
/// whether its file could be written.
class JsonFile final : public benchmark::JSONReporter {
 public:
  bool ReportContext(const Context& context) override;
  std::string text() const { return text_.str(); }
  void ReportRuns(const std::vector<Run>& runs) override;

 private:
  std::ostringstream text_;
};

std::string table(const std::vector<Scaling>& scalings);
std::string table(const std::vector<FeatureCost>& features);

}  // namespace stiction::bench
