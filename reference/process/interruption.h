// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <spawn.h>
#include <sys/types.h>

#include <functional>
#include <string>
#include <utility>

/// How a program with children ends when it is told to: Ctrl-C, kill, a terminal that is closed.
namespace stiction::reference {

/// What a signal that ended a program is added to in its exit code.
inline constexpr int kSignalled = 128;

/// From here on SIGINT, SIGTERM and SIGHUP, but for those that the caller ignores, end this program in
/// order: "<program>: interrupted", and behind it what a LastWords says, is written to stderr; its
/// children end, and what they have started; then it ends with exit code 128 + signal. Other threads go
/// on meanwhile, no destructor is run. To be called once, before there is another thread.
void end_in_order(const std::string& program);

/// What is said while it lives when the program is ended, "; 37 finished records are in …", and what is
/// done once its children have ended. Both are called by another thread.
class LastWords {
 public:
  explicit LastWords(
      std::function<std::string()> words, std::function<void()> afterwards = [] {});
  ~LastWords();
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;
};

/// While it lives the program is not ended: for the moments in which a file has a name that is not its own.
/// No other thread may start a child meanwhile.
class Uninterrupted {
 public:
  Uninterrupted();
  ~Uninterrupted();
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;
};

/// What `make` makes, and its last_words() as LastWords: the program is not ended between the two, so that
/// nothing is left on disk that nobody tells of.
template <typename Made>
class WithLastWords {
 public:
  template <typename Make>
  explicit WithLastWords(
      const Make& make, std::function<void()> afterwards = [] {})
      : WithLastWords(Uninterrupted(), make, std::move(afterwards)) {}

  Made& operator*() { return made_; }

 private:
  template <typename Make>
  WithLastWords(const Uninterrupted&, const Make& make, std::function<void()> afterwards)
      : made_(make()), words_([this] { return made_.last_words(); }, std::move(afterwards)) {}

  Made made_;
  LastWords words_;
};

/// Starts a child that is ended with this program: `start` gives its process, or one not above 0. Never
/// returns once the program is being ended.
pid_t start_child(const std::function<pid_t()>& start);

/// It has ended, by itself or not. Never returns once the program is being ended: what becomes of its
/// children then is nobody's result.
void forget_child(pid_t child);

/// Where this program ends in order: a child heeds signals as if it did not, and has a group of its own,
/// to be ended with what it starts. Else it stays in the group of this program.
void set_up_child(posix_spawnattr_t* attributes);

}  // namespace stiction::reference
