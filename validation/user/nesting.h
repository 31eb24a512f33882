// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace stiction {

/// Throws InputError "FILE:LINE: SENTENCE" where a key of the text has more parts (a.b.c has three)
/// than any problem's: the TOML library nests a table a part, and the call stack with it.
void refuse_deep_keys(std::string_view text, const std::string& file);

}  // namespace stiction
