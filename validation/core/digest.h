// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace stiction {

/// FNV-1a of the bytes, as 16 hex digits.
std::string hash_of_words(const std::string& words);
/// The same of what a file holds; that of no bytes where it cannot be read.
std::string hash_of_file(const std::filesystem::path& file);

}  // namespace stiction
