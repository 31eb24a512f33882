// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/measure/child.h"

namespace stiction::track {

Ended run(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  try {
    return reference::run_child(words, {.folder = folder});
  } catch (const reference::ChildError& error) {
    throw TrackError(error.what());
  }
}

std::string demand_run(const std::string& what, const std::vector<std::string>& words,
                       const std::filesystem::path& folder) {
  const Ended ended = run(words, folder);
  if (ended.code == 0) return ended.output;
  std::string reason = last_line(ended.errors);
  if (reason.empty()) reason = last_line(ended.output);
  if (reason.empty()) reason = words.front() + " ended with code " + std::to_string(ended.code);
  throw TrackError(what + ": " + reason);
}

bool has_program(const std::string& name) { return run({name, "--version"}).code == 0; }

}  // namespace stiction::track
