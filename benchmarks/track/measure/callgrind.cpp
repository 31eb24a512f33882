// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/measure/callgrind.h"

#include "benchmarks/track/measure/child.h"

namespace stiction::track {

double count_instructions(const std::string& what, const std::vector<std::string>& program,
                          const std::vector<std::string>& options) {
  // Not where a container forbids it: counts then repeat to some 1e-5.
  static const bool fixed_addresses = run({"setarch", "--addr-no-randomize", "true"}).code == 0;
  std::vector<std::string> words;
  if (fixed_addresses) words = {"setarch", "--addr-no-randomize"};
  words.insert(words.end(), {"valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"});
  words.insert(words.end(), options.begin(), options.end());
  words.insert(words.end(), program.begin(), program.end());
  const Ended ended = run(words);
  const std::string summary = "Collected : ";
  const std::size_t found = ended.errors.find(summary);
  if (ended.code != 0 || found == std::string::npos) {
    const std::string last = last_line(ended.errors);
    throw TrackError(what + ": " + (last.empty() ? "valgrind told no count" : last));
  }
  return std::stod(ended.errors.substr(found + summary.size()));
}

}  // namespace stiction::track
