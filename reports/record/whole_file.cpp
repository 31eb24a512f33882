// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <system_error>

namespace stiction {

namespace {

namespace fs = std::filesystem;

// Never destroyed: threads that write may outlive main.
std::shared_mutex& gate() {
  static std::shared_mutex* const one = new std::shared_mutex;
  return *one;
}

// A signal that would end a program without end_in_order waits until the file is whole.
class Unbroken {
 public:
  Unbroken() {
    sigset_t ending;
    sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ending, signal);
    pthread_sigmask(SIG_BLOCK, &ending, &before_);
  }
  ~Unbroken() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  Unbroken(const Unbroken&) = delete;
  Unbroken& operator=(const Unbroken&) = delete;

 private:
  sigset_t before_;
};

[[noreturn]] void fail(const fs::path& file, int error) {
  throw std::runtime_error(fmt::format("Cannot write \"{}\": {}.", file.string(),
                                       std::generic_category().message(error)));
}

// Returns 0 or the error's number.
int write_to(const fs::path& file, int flags, std::string_view content, Wait wait) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC | flags, kFileMode);
  if (descriptor < 0) return errno;
  const int error = write_fully(descriptor, content, wait);
  const bool closed = close(descriptor) == 0 || errno == EINTR;
  if (error != 0) return error;
  return closed ? 0 : errno;
}

}  // namespace

int write_fully(int descriptor, std::string_view content, Wait wait) {
  while (!content.empty()) {
    const ssize_t written = write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  while (wait == Wait::kYes && fdatasync(descriptor) != 0) {
    if (errno == EINTR) continue;
    // Some file systems have no such call; what was written is all that can be had there.
    return errno == EINVAL || errno == ENOSYS || errno == EOPNOTSUPP ? 0 : errno;
  }
  return 0;
}

void write_whole(const fs::path& file, std::string_view content, Wait wait) {
  const Writing writing;
  const Unbroken unbroken;
  std::error_code none;
  const fs::path target = fs::is_symlink(file, none) ? fs::canonical(file, none) : file;
  const fs::file_status found = fs::status(file, none);
  if (target.empty() || (fs::exists(found) && !fs::is_regular_file(found))) {
    if (const int error = write_to(file, O_CREAT, content, Wait::kNo); error != 0)
      fail(file, error);
    return;
  }
  const fs::path temporary =
      target.parent_path() / fmt::format(".{}.tmp", target.filename().string());
  int error = write_to(temporary, O_CREAT | O_TRUNC, content, wait);
  if (error == 0 && std::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error == 0) return;
  unlink(temporary.c_str());
  fail(file, error);
}

Writing::Writing() : lock_(gate()) {}

void end_writing() { gate().lock(); }

}  // namespace stiction
