// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reference/process/child.h"
#include "reference/process/pipe.h"

namespace stiction::reference {

struct ConversationLimits {
  double reply_seconds = 60.0;                          ///< for each answer, wall-clock
  std::uint64_t memory_bytes = std::uint64_t{4} << 30;  ///< of its data; 0: no limit
};

/// A child process that answers line by line: one question a line to its stdin, one answer a line
/// from its stdout. Whatever it does instead is a ChildError that says what, and the last line of
/// its stderr; after one the conversation is over. One thread uses it at a time.
class Conversation {
 public:
  /// Starts the program, looked up in PATH unless its name has a slash; no shell is involved.
  Conversation(std::vector<std::string> words, const ConversationLimits& limits = {});
  /// Closes its input, and ends it and what it started if it does not end by itself.
  ~Conversation();
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  /// Both lines without their line break. Throws ChildError.
  std::string ask(const std::string& line);

  /// User and system time of the process so far, all its threads, not its children, s, by the
  /// operating system; 0 once it has ended.
  double cpu_seconds() const;

  /// Its resident set, bytes, by the operating system; none once it has ended.
  std::optional<std::int64_t> resident_memory() const;

  pid_t process() const { return child_; }

 private:
  void start(std::vector<std::string>& words);
  void write_some(std::string& rest);
  void read_some(int which);
  bool take_line(std::string& line);
  [[noreturn]] void ended();
  [[noreturn]] void refuse(const std::string& what);
  int reap(bool at_once);

  ConversationLimits limits_;
  Pipe input_, output_, errors_;
  pid_t child_ = -1;
  std::string heard_;  // of stdout, not yet taken
  std::string said_;   // of stderr, the end of it
};

}  // namespace stiction::reference
