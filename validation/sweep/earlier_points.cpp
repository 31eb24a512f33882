// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/sweep/earlier_points.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>

#include "reports/text/text.h"
#include "solver/demand.h"
#include "validation/shards/record_lines.h"

namespace stiction {

namespace fs = std::filesystem;

namespace {

// A run's folder has its time for a name.
std::vector<fs::path> newest_first(const std::set<fs::path>& files) {
  std::vector<fs::path> sorted(files.begin(), files.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const fs::path& a, const fs::path& b) {
    return a.parent_path().filename() > b.parent_path().filename();
  });
  return sorted;
}

}  // namespace

std::set<fs::path> record_files(const fs::path& own, const std::vector<std::string>& others) {
  std::vector<fs::path> folders;
  if (fs::is_directory(own)) folders.push_back(own);
  for (const std::string& other : others) {
    if (!fs::is_directory(other)) throw InputError("there is no folder '" + one_line(other) + "'");
    folders.emplace_back(other);
  }
  std::set<fs::path> files;
  for (const fs::path& folder : folders) {
    for (const fs::directory_entry& one : fs::recursive_directory_iterator(folder)) {
      if (one.path().filename() == "records.jsonl") files.insert(fs::canonical(one.path()));
    }
  }
  return files;
}

std::size_t take_over(const std::set<fs::path>& files, RecordStore& store, const Points& points,
                      const std::vector<std::size_t>& own, bool retry, Results& results) {
  if (files.empty()) return 0;
  std::unordered_map<std::string, std::size_t> wanted;
  for (const std::size_t point : own) wanted[points.hash(point)] = point;
  // They are taken in their order, whatever the files', so that two that merge the same write the same.
  struct Place {
    fs::path file;
    std::uint64_t offset;
    bool broke;
  };
  std::map<std::size_t, Place> found;
  for (const fs::path& file : newest_first(files)) {
    each_record_at(file, [&](const Record& record, std::uint64_t offset) {
      const bool broke = record.verdict == Verdict::kError;
      if (record.point.empty() || (retry && broke)) return;
      const auto point = wanted.find(record.point);
      if (point == wanted.end()) return;
      const auto [known, is_new] = found.try_emplace(point->second, Place{file, offset, broke});
      if (!is_new && known->second.broke && !broke) known->second = {file, offset, broke};
    });
  }
  for (const auto& [point, place] : found) {
    Record record = record_at(place.file, place.offset);
    record.job = point;  // of another study it may be another
    store.append(record);
    results[point] = result_of(record);
  }
  return found.size();
}

}  // namespace stiction
