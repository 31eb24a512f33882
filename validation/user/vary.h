// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// What the table's `vary` names. Refuses what is no number of the file.
UserVariation read_variation(TomlTable& table, const std::shared_ptr<const ParsedFile>& parsed);

}  // namespace stiction
