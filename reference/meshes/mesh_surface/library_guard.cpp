// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesh_surface/library_guard.h"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <fstream>

namespace stiction::reference {

namespace {

// What is asked for while reading, beside what the process has: a point or a face takes some ten words
// in memory and a few signs in a file.
constexpr std::uint64_t kLeastRoom = std::uint64_t{64} << 20, kRoomOfAByte = 100;

constexpr std::array kSignals = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM};

// A handler may use nothing that could be half changed: what it says stands here beforehand.
std::string last_words, late_words;
int last_code = 0;
std::array<char, 65536> own_stack;  // the usual one may be what ran out

void end(int signal) {
  const std::string& words = signal == SIGALRM ? late_words : last_words;
  static_cast<void>(!write(STDERR_FILENO, words.data(), words.size()));
  _exit(last_code);
}

// SIGALRM once, after so long; never for 0.
void set_alarm(double seconds) {
  const double whole = std::floor(seconds);
  itimerval once{};
  once.it_value.tv_sec = static_cast<time_t>(whole);
  once.it_value.tv_usec = static_cast<suseconds_t>(std::ceil(1e6 * (seconds - whole)));
  setitimer(ITIMER_REAL, &once, nullptr);
}

void set_address_space([[maybe_unused]] std::uint64_t bytes) {
#ifndef STICTION_SANITIZES_MEMORY
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

LibraryGuard::LibraryGuard(const LibraryLimits& limits) {
  last_words = limits.fallen + "\n";
  late_words = limits.late + "\n";
  last_code = limits.code;
  stack_t stack{};
  stack.ss_sp = own_stack.data();
  stack.ss_size = own_stack.size();
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = end;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : kSignals) sigaction(signal, &action, nullptr);
  const std::uint64_t room = kLeastRoom + kRoomOfAByte * std::min(limits.bytes, kMostMemory);
  set_address_space(std::min(address_space_now() + room, kMostMemory));
  set_alarm(limits.seconds);
}

LibraryGuard::~LibraryGuard() {
  set_alarm(0.0);
  for (const int signal : kSignals) std::signal(signal, SIG_DFL);
  limit_memory();
}

}  // namespace stiction::reference
