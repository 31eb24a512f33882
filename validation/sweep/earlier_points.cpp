// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/sweep/earlier_points.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <string>
#include <unordered_map>

#include "reports/record/record_json.h"
#include "reports/text/text.h"
#include "solver/demand.h"

namespace stiction {

namespace fs = std::filesystem;

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
                      bool retry, Results& results) {
  if (files.empty()) return 0;
  std::unordered_map<std::string, std::size_t> wanted;
  for (std::size_t point = 0; point < points.size(); ++point) wanted[points.hash(point)] = point;
  std::size_t found = 0;
  for (const fs::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    each_record(stream, file.string(), [&](const Record& record) {
      if (record.point.empty() || (retry && record.verdict == Verdict::kError)) return;
      const auto point = wanted.find(record.point);
      if (point == wanted.end() || results[point->second].known) return;
      store.append(record);
      results[point->second] = result_of(record);
      ++found;
    });
  }
  return found;
}

}  // namespace stiction
