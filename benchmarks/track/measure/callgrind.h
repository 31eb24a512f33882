// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace stiction::track {

/// Instructions of a program's whole run, or of what `options` of callgrind's restrict it to. No
/// file is written, and where the system lets it, addresses are not randomised, so that
/// counts repeat. Throws TrackError
/// "<what>: <last line of stderr>" when the program, or callgrind, fails.
double count_instructions(const std::string& what, const std::vector<std::string>& program,
                          const std::vector<std::string>& options = {});

}  // namespace stiction::track
