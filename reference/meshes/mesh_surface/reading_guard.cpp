// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesh_surface/reading_guard.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>

namespace stiction::reference {

namespace {

constexpr unsigned kLongest = 60;  // s
// What is asked for while reading, beside what the process has: a point or a face takes some ten words
// in memory and a few signs in a file.
constexpr std::uint64_t kLeastRoom = std::uint64_t{64} << 20, kRoomOfAByte = 100;

constexpr std::array kSignals = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM};

// A handler may use nothing that could be half changed: what it says stands here beforehand.
std::string last_words;
int last_code = 0;
std::array<char, 65536> own_stack;  // the usual one may be what ran out

void end(int) {
  static_cast<void>(!write(STDERR_FILENO, last_words.data(), last_words.size()));
  _exit(last_code);
}

void set_address_space([[maybe_unused]] std::uint64_t bytes) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0) return;
  limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
  setrlimit(RLIMIT_AS, &limit);
#endif
}

std::uint64_t address_space_now() {
  std::ifstream told("/proc/self/statm");
  std::uint64_t pages = 0;
  told >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

void limit_memory() { set_address_space(kMostMemory); }

ReadingGuard::ReadingGuard(int code, const std::string& sentence, std::uint64_t bytes) {
  last_words = sentence + "\n";
  last_code = code;
  stack_t stack{};
  stack.ss_sp = own_stack.data();
  stack.ss_size = own_stack.size();
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = end;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : kSignals) sigaction(signal, &action, nullptr);
  const std::uint64_t room = kLeastRoom + kRoomOfAByte * std::min(bytes, kMostMemory);
  set_address_space(std::min(address_space_now() + room, kMostMemory));
  alarm(kLongest);
}

ReadingGuard::~ReadingGuard() {
  alarm(0);
  for (const int signal : kSignals) std::signal(signal, SIG_DFL);
  limit_memory();
}

}  // namespace stiction::reference
