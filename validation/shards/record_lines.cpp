// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/shards/record_lines.h"

#include <fmt/format.h>

#include <fstream>
#include <string>

#include "reports/record/record_json.h"

namespace stiction {

namespace fs = std::filesystem;

void each_record_at(const fs::path& file,
                    const std::function<void(const Record&, std::uint64_t)>& use) {
  std::ifstream stream(file, std::ios::binary);
  std::uint64_t offset = 0;
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line) && !stream.eof(); offset += line.size() + 1) {
    use(from_json_line(line, fmt::format("{}:{}", file.string(), ++number)), offset);
  }
}

Record record_at(const fs::path& file, std::uint64_t offset) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(offset));
  std::string line;
  std::getline(stream, line);
  return from_json_line(line, file.string());
}

}  // namespace stiction
