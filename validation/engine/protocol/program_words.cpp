// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/protocol/program_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "reference/process/child.h"
#include "solver/demand.h"

namespace stiction {

std::vector<std::string> command_words(const std::string& command) {
  std::vector<std::string> words;
  char quote = 0;
  bool inside = false;
  for (const char sign : command) {
    const bool begins = quote == 0 && (sign == '\'' || sign == '"');
    if (quote != 0 && sign == quote) {
      quote = 0;
    } else if (begins || (sign != ' ' && sign != '\t') || quote != 0) {
      if (!inside) words.emplace_back();
      inside = true;
      if (begins) {
        quote = sign;
      } else {
        words.back() += sign;
      }
    } else {
      inside = false;
    }
  }
  if (quote != 0) throw InputError(fmt::format("a quote does not end in: {}", command));
  return words;
}

std::vector<std::string> program_words(const std::string& words) {
  const std::vector<EngineProgram> ours = engine_programs();
  const auto found = std::find_if(ours.begin(), ours.end(),
                                  [&](const EngineProgram& one) { return one.name == words; });
  if (found != ours.end()) {
    const auto program =
        reference::find_program("engine_" + words, {reference::folder_of_this_program()});
    if (!program.empty()) return {program.string()};
    throw InputError(
        fmt::format("the engine '{}' is not built; './stiction validate --engine {}' "
                    "does that, from Debian's {}",
                    words, words, found->packages));
  }
  return command_words(words);
}

}  // namespace stiction
