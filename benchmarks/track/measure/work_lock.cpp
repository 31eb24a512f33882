// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/measure/work_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "benchmarks/track/measure/child.h"

namespace stiction::track {

WorkLock::WorkLock(const std::filesystem::path& folder) {
  std::error_code ignored;  // what is wrong shows when the file is opened
  std::filesystem::create_directories(folder, ignored);
  const std::filesystem::path file = folder / "lock";
  descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) {
    throw TrackError(fmt::format("cannot write {}: {}", file.string(), std::strerror(errno)));
  }
  // Some network file systems know no locks; there one is without, as everywhere before.
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(descriptor_);
  throw TrackError(fmt::format(
      "another ./stiction track is at work in {}; let it end, or name another folder with --work",
      folder.string()));
}

WorkLock::~WorkLock() { close(descriptor_); }

}  // namespace stiction::track
