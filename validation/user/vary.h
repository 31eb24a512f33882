// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <istream>
#include <memory>
#include <string>

#include "validation/user/reading.h"

namespace stiction {

/// A file as it was parsed, for reading it again with another value in it.
struct ParsedFile {
  std::string file;  ///< as messages call it
  toml::table root;
};

/// The problem in a parsed file, without its threshold and sweep. Throws like user_problem.
UserProblem read_parsed(const std::string& file, const toml::table& root);

/// A file's text as tables. Throws InputError with file and line for what is not TOML.
std::shared_ptr<const ParsedFile> parse_toml(std::istream& text, const std::filesystem::path& file);

/// The files that the problem's surfaces are read from, with a hash of what is in them, a line each.
std::string surface_words(const ParsedFile& problem);

/// The file's tables with this value, in its unit, where `what` says: what read_variation took.
void set_value(toml::table& root, const std::string& what, double value);

/// What the table's `vary` names. Refuses what is no number of the file.
UserVariation read_variation(TomlTable& table, const std::shared_ptr<const ParsedFile>& parsed);

}  // namespace stiction
