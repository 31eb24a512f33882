// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

/// Other programs, run as children of this one: what a child does, its crash included, is data.
namespace stiction::reference {

/// No process could be started at all, or no pipe to it: one sentence with the system's reason.
class ChildError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr int kNoSuchProgram = 127;  ///< `Ended::code`, as a shell's

struct Ended;

struct ChildOptions {
  std::filesystem::path folder{};  ///< where it runs, empty for here
  /// The child is killed after this long, s.
  double time_limit = std::numeric_limits<double>::infinity();
  bool show_errors = false;  ///< its stderr is this program's, and not kept
  /// Called some times a second while it runs, with the seconds since it was started and what it has
  /// written so far; may be empty.
  std::function<void(double, const Ended&)> meanwhile{};
};

/// How a child ended.
struct Ended {
  int code = 0;            ///< exit code; 128 + signal when a signal ended it, or kNoSuchProgram
  int signal = 0;          ///< the signal that ended it, 0 if none did
  bool timed_out = false;  ///< killed by `time_limit`
  std::string output;      ///< what it wrote to stdout
  std::string errors;      ///< what it wrote to stderr
};

/// Runs a program (looked up in PATH unless the name has a slash) with these arguments and waits
/// for it; no shell is involved, stdin is empty. STICTION_RUN_FILE is not passed on: the caller of
/// this program does not ask for what its children write. Throws ChildError.
Ended run_child(const std::vector<std::string>& words, const ChildOptions& options = {});

/// The last line with text in it, without its line break.
std::string last_line(const std::string& text);

/// The folder of the running program; empty where the system doesn't tell.
std::filesystem::path folder_of_this_program();

/// The file `name` in the first of these folders in which it may be executed; empty if in none.
std::filesystem::path find_program(const std::string& name,
                                   const std::vector<std::filesystem::path>& folders);

/// The folders of PATH, in order.
std::vector<std::filesystem::path> folders_of_path();

}  // namespace stiction::reference
