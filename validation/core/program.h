// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "reports/record/record.h"
#include "reports/text/exit_code.h"
#include "validation/engine/engine.h"

namespace stiction {

// What the programs that run cases have in common.

/// kHolds where every check holds or falls short as expected; kCouldNotRun where a record is an error.
ExitCode exit_code(const std::vector<Record>& records);

/// "NAME=VALUE" words as settings; throws InputError for another word.
Settings parse_settings(const std::vector<std::string>& words);

/// "incline/restick/box", 12 → "012-incline_restick_box": a file name that every system takes.
std::string file_stem(const std::string& case_name, std::size_t index);

}  // namespace stiction
