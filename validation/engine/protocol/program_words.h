// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace stiction {

/// "python3 'my engine.py' --fast" as words: split at spaces but within single or double quotes.
/// Throws InputError for a quote that does not end.
std::vector<std::string> command_words(const std::string& command);

/// An engine that comes with this project as a program, and what it is built from.
struct EngineProgram {
  std::string name;      ///< engine_<name> is the program
  std::string packages;  ///< Debian's, with spaces between
};

/// Written by the build from validation/engines/.
std::vector<EngineProgram> engine_programs();

/// What the words on a command line name: one of this project's programs if it is built, or a
/// command. Throws InputError.
std::vector<std::string> program_words(const std::string& words);

}  // namespace stiction
