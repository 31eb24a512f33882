// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/shards/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "reports/text/names.h"
#include "reports/text/text.h"
#include "solver/demand.h"
#include "validation/shards/record_lines.h"

namespace stiction {

namespace fs = std::filesystem;

namespace {

constexpr const char* kRecords = "records.jsonl";

std::vector<fs::path> runs_in(const std::vector<std::string>& folders) {
  std::set<fs::path> runs;
  for (const std::string& folder : folders) {
    if (!fs::is_directory(folder)) {
      throw InputError("there is no folder '" + one_line(folder) + "'");
    }
    // 'latest' may be what is named; inside, links lead to what is found anyway.
    const fs::path real = fs::canonical(folder);
    if (fs::exists(real / kRunFile)) runs.insert(real);
    each_file_named(kRunFile, real, [&](const fs::path& file) { runs.insert(file.parent_path()); });
  }
  std::vector<fs::path> newest(runs.begin(), runs.end());
  std::stable_sort(newest.begin(), newest.end(), is_later);
  return newest;
}

}  // namespace

Parts::Parts(const std::vector<std::string>& folders) : folders_(runs_in(folders)) {
  if (folders_.empty()) {
    throw InputError(fmt::format("no run of a part is in {} ({} says what a folder is)",
                                 listed_names(folders), kRunFile));
  }
  for (const fs::path& folder : folders_) {
    RunPlan plan = read_plan(folder / kRunFile);
    shards_.push_back(plan.shard);
    if (plan_.plan.empty()) {
      plan_ = std::move(plan);
    } else if (plan.plan != plan_.plan || plan.jobs != plan_.jobs) {
      throw InputError(fmt::format(
          "'{}' and '{}' are parts of different runs: another command, other files or an "
          "earlier version of them, another engine, or another revision of the suite; "
          "name the folders of the run that is meant",
          one_line(folders_.front().string()), one_line(folder.string())));
    }
  }
  places_.resize(plan_.jobs);
  for (std::uint32_t part = 0; part < folders_.size(); ++part) take(part);
}

void Parts::take(std::uint32_t part) {
  const fs::path file = folders_[part] / kRecords;
  each_record_at(file, [&](const Record& record, std::uint64_t offset) {
    if (!record.job) return;  // what was made of several
    if (*record.job >= places_.size()) {
      throw std::runtime_error(fmt::format("{}: job {} of a run of {}", one_line(file.string()),
                                           *record.job, places_.size()));
    }
    const Place place{part, record.verdict == Verdict::kError, offset};
    std::optional<Place>& known = places_[*record.job];
    if (!known || (known->broke && !place.broke)) known = place;
  });
}

std::string Parts::missing() const {
  const auto absent = static_cast<std::size_t>(std::count_if(
      places_.begin(), places_.end(), [](const std::optional<Place>& one) { return !one; }));
  if (absent == 0) return "";
  std::string words = fmt::format("{} of {} jobs have no result", absent, places_.size());
  const std::size_t count = shards_.front().count;
  std::set<std::size_t> there;
  for (const Shard& one : shards_) {
    if (one.count == count) there.insert(one.number);
  }
  constexpr std::size_t kMostTold = 10;
  std::vector<std::size_t> lost;
  for (std::size_t number = 1; number <= count && lost.size() < kMostTold; ++number) {
    if (there.count(number) == 0) lost.push_back(number);
  }
  if (lost.empty()) return words + ": a part was interrupted";
  const std::size_t all = count - there.size();
  return words +
         fmt::format(": of {} parts {}{} {} missing", count, fmt::join(lost, ", "),
                     all > lost.size() ? fmt::format(" and {} more", all - lost.size()) : "",
                     all == 1 ? "is" : "are");
}

const Parts::Place& Parts::place(std::size_t job) const {
  if (job >= places_.size() || !places_[job]) {
    throw std::runtime_error(fmt::format("job {} has no result in the parts", job));
  }
  return *places_[job];
}

Record Parts::record(std::size_t job) const {
  const Place& where = place(job);
  return record_at(folders_[where.part] / kRecords, where.offset);
}

const fs::path& Parts::folder(std::size_t job) const { return folders_[place(job).part]; }

void take_recording(const Record& record, const fs::path& from, const fs::path& to) {
  if (record.frames.empty()) return;
  const fs::path name = fs::path(record.frames).filename();
  if (record.frames != "frames/" + name.string()) {
    throw std::runtime_error("a recording's name is no file of its run: '" +
                             one_line(record.frames) + "'");
  }
  fs::create_directories(to / "frames");
  fs::copy_file(from / "frames" / name, to / "frames" / name, fs::copy_options::overwrite_existing);
}

}  // namespace stiction
