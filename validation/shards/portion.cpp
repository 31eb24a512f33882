// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/shards/portion.h"

#include <fmt/format.h>

#include <utility>

#include "reports/screen/program.h"
#include "solver/demand.h"

namespace stiction {

std::optional<Parts> parts_of(const RunPlan& plan, const PortionWords& words) {
  if (words.parts.empty()) return std::nullopt;
  if (!words.shard.empty()) throw InputError("--shard and --parts exclude each other");
  Parts parts(words.parts);
  const RunPlan& found = parts.plan();
  if (found.program != plan.program || found.plan != plan.plan || found.jobs != plan.jobs) {
    throw InputError(
        "the parts are not of this run: another command, other files or an earlier version of "
        "them, "
        "another engine, or another revision of the suite");
  }
  const std::string missing = parts.missing();
  if (!missing.empty()) throw InputError(missing);
  return parts;
}

std::string part_text(const Shard& shard, std::size_t own, std::size_t all, const char* what) {
  return fmt::format("part {} of {}, {} of {} {}", shard.number, shard.count, own, all, what);
}

Portion::Portion(const std::string& program, const std::vector<Job>& all, Together together,
                 const PortionWords& words, const std::string& depends)
    : plan_{program, words.command, plan_of(all, depends), all.size(), {}} {
  parts_ = parts_of(plan_, words);
  if (!parts_) plan_.shard = shard_from(words.shard);
  numbers_ = jobs_of(plan_.shard, all, together);
  for (const std::size_t number : numbers_) jobs_.push_back(all[number]);
}

std::string Portion::text() const {
  if (is_whole()) return "";
  return part_text(plan_.shard, jobs_.size(), plan_.jobs, "jobs");
}

void Portion::finish_part(RecordStore& store) const {
  store.finish();
  tell(fmt::format("{}: {} (./stiction merge puts the parts together)", text(),
                   store.records_file().string()));
}

void Portion::run(RecordStore& store, int threads, double tolerance_scale,
                  const std::function<void(std::size_t, Record)>& finished,
                  const KeepRecording& keep) const {
  write_plan(store, plan_);
  const auto numbered = [&](std::size_t job, Record record) {
    record.job = numbers_[job];
    finished(job, std::move(record));
  };
  if (!parts_) {
    const std::vector<std::size_t> order = order_to_begin(estimated_seconds(jobs_), threads);
    return run_jobs(jobs_, order, threads, tolerance_scale, numbered, keep);
  }
  for (std::size_t job = 0; job < jobs_.size(); ++job) {
    Record record = parts_->record(numbers_[job]);
    take_recording(record, parts_->folder(numbers_[job]), store.folder());
    numbered(job, std::move(record));
  }
}

}  // namespace stiction
