// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace stiction::track {

/// 16 hex digits of a file's content (FNV-1a, 64 bits). Throws TrackError when it cannot be read.
std::string content_hash(const std::filesystem::path& file);

/// The text that `make` gave for `key` on this machine before, kept as a file in `folder`; made now
/// when there is none or `fresh`. Written whole or not at all.
std::string remembered(const std::filesystem::path& folder, const std::string& key, bool fresh,
                       const std::function<std::string()>& make);

}  // namespace stiction::track
