// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/process/child.h"
#include "reports/text/text.h"

namespace stiction::track {

/// What could not be measured or read: one clear sentence in one line for the user (exit code 2), whatever
/// others' words are in it.
class TrackError : public std::runtime_error {
 public:
  explicit TrackError(const std::string& what) : std::runtime_error(one_line(what)) {}
};

using reference::Ended;
using reference::last_line;

/// Runs a program (looked up in PATH) with these arguments and waits for it; no shell is involved.
/// `folder` is where it runs, empty for here. Throws TrackError when no process can be started.
Ended run(const std::vector<std::string>& words, const std::filesystem::path& folder = {});

/// As `run`, but throws TrackError "<what>: <last line of its stderr or stdout>" unless it ends
/// with exit code 0; gives its stdout.
std::string demand_run(const std::string& what, const std::vector<std::string>& words,
                       const std::filesystem::path& folder = {});

/// Whether a program of this name can be run.
bool has_program(const std::string& name);

}  // namespace stiction::track
