// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace stiction::track {

/// What could not be measured or read: one clear sentence for the user (exit code 2).
class TrackError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How a child process ended.
struct Ended {
  int code = 0;        ///< exit code; 128 + signal when a signal ended it, 127 when not found
  std::string output;  ///< what it wrote to stdout
  std::string errors;  ///< what it wrote to stderr
};

/// Runs a program (looked up in PATH) with these arguments and waits for it; no shell is involved.
/// `folder` is where it runs, empty for here. Throws TrackError when no process can be started.
Ended run(const std::vector<std::string>& words, const std::filesystem::path& folder = {});

/// As `run`, but throws TrackError "<what>: <last line of its stderr or stdout>" unless it ends
/// with exit code 0; gives its stdout.
std::string demand_run(const std::string& what, const std::vector<std::string>& words,
                       const std::filesystem::path& folder = {});

/// Whether a program of this name can be run.
bool has_program(const std::string& name);

/// The last line with text in it, without its line break.
std::string last_line(const std::string& text);

}  // namespace stiction::track
