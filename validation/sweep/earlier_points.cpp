// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/sweep/earlier_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>

#include "reports/record/record_json.h"
#include "reports/screen/program.h"
#include "reports/text/text.h"
#include "solver/demand.h"
#include "validation/shards/record_lines.h"

namespace stiction {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> newest_first(const std::set<fs::path>& files) {
  std::vector<fs::path> sorted(files.begin(), files.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const fs::path& a, const fs::path& b) {
    return is_later(a.parent_path(), b.parent_path());
  });
  return sorted;
}

// What a line of a record says is its point, without reading all of it: most are not wanted.
std::string point_in(const std::string& line) {
  constexpr std::string_view kKey = "\"point\":\"";
  constexpr std::size_t kDigits = 16;
  const std::size_t at = line.rfind(kKey);
  return at == std::string::npos ? "" : line.substr(at + kKey.size(), kDigits);
}

// None where a line is damaged, which is told: its point is computed again.
std::optional<Record> record_in(const std::string& line, const std::string& where) {
  try {
    return from_json_line(line, where);
  } catch (const std::runtime_error& error) {
    tell(std::string(error.what()) + ": left out");
    return std::nullopt;
  }
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
    each_file_named("records.jsonl", folder,
                    [&](const fs::path& file) { files.insert(fs::canonical(file)); });
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
    each_line_at(file, [&](const std::string& line, std::size_t number, std::uint64_t offset) {
      const auto point = wanted.find(point_in(line));
      if (point == wanted.end()) return;
      const auto record = record_in(line, fmt::format("{}:{}", file.string(), number));
      if (!record || record->point != point->first) return;
      const bool broke = record->verdict == Verdict::kError;
      if (retry && broke) return;
      const auto [known, is_new] = found.try_emplace(point->second, Place{file, offset, broke});
      if (!is_new && known->second.broke && !broke) known->second = {file, offset, broke};
    });
  }
  for (const auto& [point, place] : found) {
    // Another study may call it otherwise.
    const Record record = points.finished(point, record_at(place.file, place.offset));
    store.append(record);
    results[point] = result_of(record);
  }
  return found.size();
}

std::size_t take_parts(const Parts& parts, RecordStore& store, const Points& points,
                       Results& results) {
  for (std::size_t point = 0; point < points.size(); ++point) {
    const Record record = parts.record(point);
    store.append(record);
    results[point] = result_of(record);
  }
  return points.size();
}

}  // namespace stiction
