// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/process/interruption.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

namespace stiction::reference {

namespace {

constexpr unsigned kLongest = 10;                 // s, for all of it: a disk may never answer
constexpr auto kToEnd = std::chrono::seconds(2);  // for children, before they are killed
constexpr auto kTick = std::chrono::milliseconds(10);

struct Shared {
  std::recursive_mutex mutex;  // of what follows
  std::set<pid_t> children;
  std::function<std::string()> words = [] { return ""; };
  std::function<void()> afterwards = [] {};
  bool in_order = false;  // set before there is another thread
  sigset_t heeded, mask_before;
};

// Never destroyed: the watching thread outlives main.
Shared& shared() {
  static Shared* const one = new Shared;
  return *one;
}

// Whether nothing of the child's group is left; its own process is collected.
bool is_gone(pid_t child) {
  waitpid(child, nullptr, WNOHANG);
  return kill(-child, 0) != 0 && errno == ESRCH;
}

void end_all(const std::set<pid_t>& children) {
  for (const pid_t child : children) {
    kill(-child, SIGTERM);
    kill(-child, SIGCONT);  // one that was stopped ends too
  }
  const auto deadline = std::chrono::steady_clock::now() + kToEnd;
  while (!std::all_of(children.begin(), children.end(), is_gone) &&
         std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(kTick);
  }
  for (const pid_t child : children) kill(-child, SIGKILL);
}

void say(const std::string& text) {
  // On a terminal the cursor stands behind what was last told, or behind ^C.
  const std::string line = (isatty(STDERR_FILENO) != 0 ? "\n" : "") + text + "\n";
  // Not by stderr's buffer, whose lock another thread may hold.
  if (write(STDERR_FILENO, line.data(), line.size()) < 0) return;
}

void watch(const std::string& program) {
  int signal = 0;
  while (sigwait(&shared().heeded, &signal) != 0) {
  }
  alarm(kLongest);
  // Held to the end: a thread that would start or forget a child waits here.
  shared().mutex.lock();
  say(program + ": interrupted" + shared().words());
  end_all(shared().children);
  shared().afterwards();
  _exit(kSignalled + signal);
}

}  // namespace

void end_in_order(const std::string& program) {
  Shared& all = shared();
  sigemptyset(&all.heeded);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    if (now.sa_handler != SIG_IGN) sigaddset(&all.heeded, signal);
  }
  pthread_sigmask(SIG_BLOCK, &all.heeded, &all.mask_before);
  all.in_order = true;
  std::thread(watch, program).detach();
}

LastWords::LastWords(std::function<std::string()> words, std::function<void()> afterwards) {
  const std::lock_guard lock(shared().mutex);
  shared().words = std::move(words);
  shared().afterwards = std::move(afterwards);
}

LastWords::~LastWords() {
  const std::lock_guard lock(shared().mutex);
  shared().words = [] { return ""; };
  shared().afterwards = [] {};
}

Uninterrupted::Uninterrupted() { shared().mutex.lock(); }

Uninterrupted::~Uninterrupted() { shared().mutex.unlock(); }

pid_t start_child(const std::function<pid_t()>& start) {
  const std::lock_guard lock(shared().mutex);
  const pid_t child = start();
  if (child > 0) shared().children.insert(child);
  return child;
}

void forget_child(pid_t child) {
  const std::lock_guard lock(shared().mutex);
  shared().children.erase(child);
}

void set_up_child(posix_spawnattr_t* attributes) {
  if (!shared().in_order) return;
  posix_spawnattr_setpgroup(attributes, 0);
  posix_spawnattr_setsigmask(attributes, &shared().mask_before);
  posix_spawnattr_setflags(attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
}

}  // namespace stiction::reference
