// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/callgrind.h"

#include "benchmarks/track/child.h"

namespace stiction::track {

double count_instructions(const std::string& what, const std::vector<std::string>& program,
                          const std::vector<std::string>& options) {
  std::vector<std::string> words = {"setarch", "--addr-no-randomize", "valgrind",
                                    "--tool=callgrind", "--callgrind-out-file=/dev/null"};
  words.insert(words.end(), options.begin(), options.end());
  words.insert(words.end(), program.begin(), program.end());
  const Ended ended = run(words);
  const std::string summary = "Collected : ";
  const std::size_t found = ended.errors.find(summary);
  if (ended.code != 0 || found == std::string::npos) {
    throw TrackError(what + ": " + last_line(ended.errors));
  }
  return std::stod(ended.errors.substr(found + summary.size()));
}

}  // namespace stiction::track
