// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesh_cache.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "reference/process/interruption.h"

namespace stiction::reference {

namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".mesh";
constexpr const char* kNew = "new-";

// FNV-1a, 64 bits: against accidents, not against forgers, as whoever writes to this folder could write
// to the user's files too.
std::uint64_t hash(std::string_view text) {
  std::uint64_t value = 0xcbf29ce484222325;
  for (const char sign : text) {
    value = (value ^ static_cast<unsigned char>(sign)) * 0x100000001b3;
  }
  return value;
}

// Of a mesher its hash will do: it is this project's own.
std::string words_of(const MeshOrigin& origin) {
  return fmt::format("stiction mesh 1\nmesher {:016x}\noptions {}\nformat {}\nsurface {}\n{}\n",
                     hash(origin.mesher), origin.options, origin.format, origin.surface.size(),
                     origin.surface);
}

std::string sum_of(std::string_view text) { return fmt::format("{:016x}\n", hash(text)); }

std::error_code last_error() { return {errno, std::generic_category()}; }

std::error_code write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = write(descriptor, content.data(), content.size());
    if (written < 0 && errno != EINTR) return last_error();
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

// The newest stay, and of what was being written that of the last hour.
void tidy(const fs::path& folder) {
  std::error_code none;
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const fs::file_time_type written = entry.last_write_time(none);
    if (entry.path().extension() == kEnding) files.emplace_back(written, entry);
    if (entry.path().filename().string().starts_with(kNew) && written < old) {
      fs::remove(entry, none);
    }
  }
  if (files.size() <= MeshCache::kMostMeshes) return;
  std::sort(files.begin(), files.end());
  files.resize(files.size() - MeshCache::kMostMeshes);
  for (const auto& [time, file] : files) fs::remove(file, none);
}

}  // namespace

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

fs::path MeshCache::file_of(const std::string& words) const {
  return folder_ / (fmt::format("{:016x}", hash(words)) + kEnding);
}

std::optional<FilledSurface> MeshCache::find(const MeshOrigin& origin) const {
  if (folder_.empty()) return std::nullopt;
  const std::string words = words_of(origin);
  const std::string content = content_of(file_of(words));
  const std::size_t sum = sum_of("").size();
  if (!content.starts_with(words) || content.size() < words.size() + sum) return std::nullopt;
  const std::string_view summed = std::string_view(content).substr(0, content.size() - sum);
  if (!content.ends_with(sum_of(summed))) return std::nullopt;
  try {
    return filled_surface_from(summed.substr(words.size()));
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::string MeshCache::keep(const MeshOrigin& origin, const FilledSurface& filled) const {
  if (folder_.empty()) return "";
  std::error_code wrong;
  fs::create_directories(folder_, wrong);
  const auto why_not = [&] { return folder_.string() + ": " + wrong.message(); };
  if (wrong) return why_not();
  const std::string words = words_of(origin);
  std::string content = words + to_text(filled);
  content += sum_of(content);
  // A name of its own, so that two at once do not write to one file.
  std::string temporary = (folder_ / (std::string(kNew) + "XXXXXX")).string();
  {
    const Uninterrupted until_named;
    const int descriptor = mkstemp(temporary.data());
    if (descriptor < 0) {
      wrong = last_error();
      return why_not();
    }
    wrong = write_all(descriptor, content);
    if (close(descriptor) != 0 && !wrong) wrong = last_error();
    if (!wrong) fs::rename(temporary, file_of(words), wrong);
    std::error_code none;
    if (wrong) fs::remove(temporary, none);
  }
  tidy(folder_);
  return wrong ? why_not() : "";
}

fs::path mesh_cache_folder() {
  const char* const named = std::getenv("XDG_CACHE_HOME");
  if (named != nullptr && fs::path(named).is_absolute()) return fs::path(named) / "stiction/meshes";
  const char* const home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') return {};
  return fs::path(home) / ".cache/stiction/meshes";
}

}  // namespace stiction::reference
