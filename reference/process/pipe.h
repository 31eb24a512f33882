// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <spawn.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

// What child.cpp and conversation.cpp have in common.
namespace stiction::reference {

/// Throws ChildError: what, and the system's reason.
[[noreturn]] void fail(const std::string& what, int number);

/// Both ends are closed at exec, so that no child keeps another's pipe open.
class Pipe {
 public:
  Pipe();  ///< throws ChildError
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int end(std::size_t which) const { return end_[which]; }  ///< 0 to read, 1 to write
  void close_end(std::size_t which);

 private:
  std::array<int, 2> end_{-1, -1};
};

/// What a child does before it runs its program.
class Actions {
 public:
  Actions() { posix_spawn_file_actions_init(&actions_); }
  ~Actions() { posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  posix_spawn_file_actions_t* get() { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// How a child is started.
class Attributes {
 public:
  Attributes() { posix_spawnattr_init(&attributes_); }
  ~Attributes() { posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  posix_spawnattr_t* get() { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

/// This program's, but for what children are not told; ends with null.
std::vector<char*> environment_of_child();

class Deadline {
 public:
  explicit Deadline(double seconds) : seconds_(seconds), start_(std::chrono::steady_clock::now()) {}

  bool passed() const { return left() <= 0.0; }
  /// For poll, ms: −1 waits as long as it takes.
  int wait() const;

 private:
  double left() const;  // s

  double seconds_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace stiction::reference
