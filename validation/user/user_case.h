// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "validation/core/case.h"

namespace stiction {

/// Reads a person's own problem (user_problem.h) as a case named after the file. Throws InputError
/// with one sentence that names the file, and the line of a mistake in it.
Case read_user_problem(const std::filesystem::path& file);

}  // namespace stiction
