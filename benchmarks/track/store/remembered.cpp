// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/store/remembered.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <system_error>

#include "benchmarks/track/measure/child.h"
#include "reports/record/environment.h"
#include "reports/record/whole_file.h"
#include "solver/hash.h"

namespace stiction::track {

std::string content_hash(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw TrackError(fmt::format("cannot read {}", file.string()));
  Fnv1a hash;
  std::array<char, 65536> buffer;
  while (stream.read(buffer.data(), buffer.size()) || stream.gcount() > 0) {
    hash.add(buffer.data(), static_cast<std::size_t>(stream.gcount()));
  }
  return fmt::format("{:016x}", hash.value());
}

std::string remembered(const std::filesystem::path& folder, const std::string& key, bool fresh,
                       const std::function<std::string()>& make) {
  const std::string whole_key = key + " " + current_environment().machine;
  Fnv1a name;
  name.add(whole_key.data(), whole_key.size());
  const std::filesystem::path file = folder / fmt::format("{:016x}", name.value());
  if (!fresh) {
    std::ifstream stream(file);
    std::string line;
    // The first line is the key itself: two keys of one hash are told apart.
    if (stream && std::getline(stream, line) && line == whole_key) {
      return std::string(std::istreambuf_iterator<char>(stream), {});
    }
  }
  const std::string text = make();
  std::error_code none;  // what is wrong shows when the file is written
  std::filesystem::create_directories(folder, none);
  write_whole(file, whole_key + '\n' + text);
  return text;
}

}  // namespace stiction::track
