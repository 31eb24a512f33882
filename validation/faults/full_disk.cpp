// SPDX-License-Identifier: GPL-3.0-or-later
// A disk that is full from the N-th write on: preloaded into a program (LD_PRELOAD) it stands in for the calls
// by which files are made and written. full_disk.py says what is held to.
//
//   FULL_DISK_IN       folder whose files it is about, absolute
//   FULL_DISK_COUNTER  file of 8 bytes, the number of such calls so far, of a program and its children
//   FULL_DISK_LOG      file that gets a line of the call that failed first: "write /folder/file"
//   FULL_DISK_AT       N; 0 only counts
//   FULL_DISK_KIND     from: the N-th call and all behind it fail with ENOSPC; once: it alone;
//                      short: as from, but the N-th, if it is a write, takes half of its bytes
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

enum class Fate { kFine, kHalf, kFails };

struct Setting {
  std::string folder, kind;
  std::uint64_t at = 0;
  std::atomic<std::uint64_t>* count = nullptr;
};

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// Read before the program can change its environment, and never destroyed.
const Setting& setting() {
  static const Setting* const one = [] {
    auto* const read = new Setting;
    read->folder = variable("FULL_DISK_IN");
    read->kind = variable("FULL_DISK_KIND");
    read->at = std::strtoull(variable("FULL_DISK_AT").c_str(), nullptr, 10);
    const long file =
        syscall(SYS_openat, AT_FDCWD, variable("FULL_DISK_COUNTER").c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0) return read;
    void* const shared = mmap(nullptr, sizeof(std::uint64_t), PROT_READ | PROT_WRITE, MAP_SHARED,
                              static_cast<int>(file), 0);
    syscall(SYS_close, file);
    if (shared != MAP_FAILED) read->count = static_cast<std::atomic<std::uint64_t>*>(shared);
    return read;
  }();
  return *one;
}

void tell(const std::string& line) {
  const long file = syscall(SYS_openat, AT_FDCWD, variable("FULL_DISK_LOG").c_str(),
                            O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) return;
  syscall(SYS_write, file, line.data(), line.size());
  syscall(SYS_close, file);
}

Fate fate(const char* call, const std::string& path) {
  const Setting& all = setting();
  if (all.count == nullptr || all.folder.empty() || path.rfind(all.folder + "/", 0) != 0)
    return Fate::kFine;
  const std::uint64_t number = ++*all.count;
  if (all.at == 0 || number < all.at || (number > all.at && all.kind == "once")) return Fate::kFine;
  if (number == all.at) tell(std::string(call) + " " + path + "\n");
  errno = ENOSPC;
  return number == all.at && all.kind == "short" ? Fate::kHalf : Fate::kFails;
}

std::string absolute(const char* path) {
  if (path[0] == '/') return path;
  char folder[4096];
  return getcwd(folder, sizeof folder) == nullptr ? path : std::string(folder) + "/" + path;
}

std::string path_of(int descriptor) {
  char path[4096];
  const ssize_t size =
      readlink(("/proc/self/fd/" + std::to_string(descriptor)).c_str(), path, sizeof path);
  return size < 0 ? "" : std::string(path, static_cast<std::size_t>(size));
}

// Whether a call about this path fails. Only a write can be done by half.
bool fails(const char* call, const char* path) { return fate(call, absolute(path)) != Fate::kFine; }

Fate fate_of_write(const char* call, int descriptor) {
  const int before = errno;
  const Fate found = fate(call, path_of(descriptor));
  if (found == Fate::kFine) errno = before;
  return found;
}

bool fails(const char* call, int descriptor) {
  return fate_of_write(call, descriptor) != Fate::kFine;
}

// That a folder is synced is best effort.
bool is_file(int descriptor) {
  struct stat what;
  return fstat(descriptor, &what) == 0 && S_ISREG(what.st_mode);
}

bool makes(int flags) { return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE; }

template <class Function>
Function* real(Function*, const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

#define REAL(name) static auto* const theirs = real(&name, #name)

extern "C" {

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = makes(flags) ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  REAL(open);
  return makes(flags) && fails("open", path) ? -1 : theirs(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = makes(flags) ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  REAL(open64);
  return makes(flags) && fails("open", path) ? -1 : theirs(path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = makes(flags) ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  REAL(openat);
  return makes(flags) && fails("open", path) ? -1 : theirs(folder, path, flags, mode);
}

FILE* fopen(const char* path, const char* mode) {
  REAL(fopen);
  return mode[0] != 'r' && fails("open", path) ? nullptr : theirs(path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
  REAL(fopen64);
  return mode[0] != 'r' && fails("open", path) ? nullptr : theirs(path, mode);
}

int mkstemp(char* path) {
  REAL(mkstemp);
  return fails("open", path) ? -1 : theirs(path);
}

int mkstemp64(char* path) {
  REAL(mkstemp64);
  return fails("open", path) ? -1 : theirs(path);
}

char* mkdtemp(char* path) {
  REAL(mkdtemp);
  return fails("mkdir", path) ? nullptr : theirs(path);
}

int mkdir(const char* path, mode_t mode) {
  REAL(mkdir);
  // What is there already needs no room, nor does what has no name.
  struct stat there;
  const bool made = *path != '\0' && stat(path, &there) != 0;
  return made && fails("mkdir", path) ? -1 : theirs(path, mode);
}

int rename(const char* from, const char* to) {
  REAL(rename);
  return fails("rename", to) ? -1 : theirs(from, to);
}

int symlink(const char* target, const char* path) {
  REAL(symlink);
  return fails("symlink", path) ? -1 : theirs(target, path);
}

int fsync(int file) {
  REAL(fsync);
  return is_file(file) && fails("fsync", file) ? -1 : theirs(file);
}

int fdatasync(int file) {
  REAL(fdatasync);
  return is_file(file) && fails("fsync", file) ? -1 : theirs(file);
}

ssize_t write(int file, const void* bytes, size_t size) {
  REAL(write);
  const Fate found = fate_of_write("write", file);
  if (found == Fate::kFails || (found == Fate::kHalf && size < 2)) return -1;
  return theirs(file, bytes, found == Fate::kHalf ? size / 2 : size);
}

ssize_t writev(int file, const iovec* parts, int count) {
  REAL(writev);
  const Fate found = fate_of_write("write", file);
  if (found == Fate::kFails || (found == Fate::kHalf && count < 2)) return -1;
  return theirs(file, parts, found == Fate::kHalf ? count / 2 : count);
}

ssize_t pwrite(int file, const void* bytes, size_t size, off_t at) {
  REAL(pwrite);
  const Fate found = fate_of_write("write", file);
  if (found == Fate::kFails || (found == Fate::kHalf && size < 2)) return -1;
  return theirs(file, bytes, found == Fate::kHalf ? size / 2 : size, at);
}

ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t at) {
  REAL(pwrite64);
  const Fate found = fate_of_write("write", file);
  if (found == Fate::kFails || (found == Fate::kHalf && size < 2)) return -1;
  return theirs(file, bytes, found == Fate::kHalf ? size / 2 : size, at);
}

}  // extern "C"
