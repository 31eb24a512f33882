// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/shards/record_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <tuple>

#include "reports/record/record_json.h"
#include "reports/text/text.h"

namespace stiction {

namespace fs = std::filesystem;

namespace {

std::ifstream opened(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw std::runtime_error(fmt::format("cannot open '{}': {}", one_line(file.string()),
                                         std::generic_category().message(errno)));
  }
  return stream;
}

}  // namespace

void each_file_named(const std::string& name, const fs::path& folder,
                     const std::function<void(const fs::path&)>& use) {
  try {
    for (const fs::directory_entry& one : fs::recursive_directory_iterator(folder)) {
      if (one.path().filename() == name && one.is_regular_file()) use(one.path());
    }
  } catch (const fs::filesystem_error& error) {
    throw std::runtime_error(fmt::format("cannot read all of the folder '{}': {}",
                                         one_line(folder.string()), error.code().message()));
  }
}

bool is_later(const fs::path& run, const fs::path& other) {
  const auto place = [](const fs::path& folder) {
    const std::string name = folder.filename().string();
    const std::size_t end = std::min(name.find('Z'), name.size());
    // "-12" after "-9": longer behind the time is later.
    return std::tuple(name.substr(0, end), name.size(), name);
  };
  return place(run) > place(other);
}

void each_line_at(const fs::path& file,
                  const std::function<void(const std::string&, std::size_t, std::uint64_t)>& use) {
  std::ifstream stream = opened(file);
  std::uint64_t offset = 0;
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line) && !stream.eof(); offset += line.size() + 1) {
    use(line, ++number, offset);
  }
}

void each_record_at(const fs::path& file,
                    const std::function<void(const Record&, std::uint64_t)>& use) {
  each_line_at(file, [&](const std::string& line, std::size_t number, std::uint64_t offset) {
    use(from_json_line(line, fmt::format("{}:{}", file.string(), number)), offset);
  });
}

Record record_at(const fs::path& file, std::uint64_t offset) {
  std::ifstream stream = opened(file);
  stream.seekg(static_cast<std::streamoff>(offset));
  std::string line;
  std::getline(stream, line);
  return from_json_line(line, file.string());
}

}  // namespace stiction
