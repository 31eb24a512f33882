// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <map>
#include <numeric>
#include <utility>

#include "reports/formats/failure_block.h"
#include "reports/formats/table.h"
#include "reports/record/record_json.h"
#include "reports/screen/program.h"

namespace stiction {

namespace {

// What an earlier run took for these jobs, CPU s; jobs that it hasn't got take what they do on average.
std::vector<double> weights_of(const std::vector<Job>& jobs, const std::filesystem::path& earlier) {
  std::map<std::string, double> seconds;  // by case and engine, a variant's on average
  std::map<std::string, int> counts;
  double sum = 0.0;
  std::size_t records = 0;
  try {
    for (const Record& record : read_records(earlier).records) {
      const std::string key = record.case_name + "\n" + record.engine;
      seconds[key] += record.cost.cpu_seconds;
      ++counts[key];
      sum += record.cost.cpu_seconds;
      ++records;
    }
  } catch (const std::exception&) {
    seconds.clear();  // none, or not readable: that is no fault of this run
  }
  constexpr double kLeast = 0.02;  // s: starting a case takes that
  const double usual = seconds.empty() ? 1.0 : sum / static_cast<double>(records) + kLeast;
  std::vector<double> weights;
  for (const Job& job : jobs) {
    const std::string key = job.which.name + "\n" + job.engine.name;
    const auto found = seconds.find(key);
    weights.push_back(found == seconds.end() ? usual : found->second / counts[key] + kLeast);
  }
  return weights;
}

// Only where a line of progress is to be seen.
std::filesystem::path if_moving(const std::filesystem::path& earlier) {
  return screen_of(STDERR_FILENO).moving ? earlier : std::filesystem::path();
}

}  // namespace

Console::Console(const std::vector<Job>& jobs, const Screen& screen, ConsoleOptions options)
    : options_(std::move(options)),
      screen_(screen),
      jobs_(jobs),
      weights_(weights_of(jobs, if_moving(options_.earlier))),
      total_(std::accumulate(weights_.begin(), weights_.end(), 0.0)),
      waiting_(jobs.size()),
      progress_(jobs.size()) {
  if (options_.verbose) show(table_header(screen_));
  std::fflush(stdout);
  show_progress();
}

void Console::finished(std::size_t index, const Record& record) {
  work_done_ += weights_[index];
  ++count_done_;
  progress_.clear();
  if (record.verdict == Verdict::kError) {
    tell(fmt::format("stiction validate: {}: {}", record.case_name, record.error));
  }
  // What an engine cannot take stands in a few lines at the end.
  waiting_[index] = options_.verbose && record.verdict != Verdict::kNotApplicable
                        ? table_rows(record, screen_)
                        : std::string();
  if (!options_.quiet) *waiting_[index] += failure_block(record, screen_, options_.rerun(record));
  while (next_ < waiting_.size() && waiting_[next_]) show(*waiting_[next_++]);
  std::fflush(stdout);
  show_progress();
}

void Console::show_progress() {
  if (count_done_ == jobs_.size()) return;
  progress_.show(count_done_, jobs_[next_].which.name, work_done_ / total_);
}

}  // namespace stiction
