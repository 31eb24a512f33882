// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/store/scratch.h"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <mutex>
#include <set>
#include <system_error>

#include "benchmarks/track/measure/child.h"

namespace stiction::track {

namespace {

struct Folders {
  std::mutex mutex;
  std::set<std::filesystem::path> all;
};

Folders& folders() {
  static Folders* const one = new Folders;  // outlives main, as who removes them all may
  return *one;
}

void clear(const std::filesystem::path& folder) {
  std::error_code ignored;  // what the system keeps, it clears itself
  std::filesystem::remove_all(folder, ignored);
}

}  // namespace

Scratch::Scratch() {
  const std::lock_guard lock(folders().mutex);
  std::string name = (std::filesystem::temp_directory_path() / "stiction-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw TrackError(std::string("cannot make the temporary folder ") + name + ": " +
                     std::strerror(errno));
  }
  folder_ = name;
  folders().all.insert(folder_);
}

Scratch::~Scratch() {
  const std::lock_guard lock(folders().mutex);
  clear(folder_);
  folders().all.erase(folder_);
}

void Scratch::remove_all() {
  folders().mutex.lock();  // for good
  for (const std::filesystem::path& folder : folders().all) clear(folder);
}

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace stiction::track
