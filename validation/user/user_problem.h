// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "validation/core/case.h"

namespace stiction {

/// Reads a person's own problem (TOML; validation/user/examples/ramp.toml explains each key) as a
/// case named after the file. Throws InputError with one sentence that names the file, and the line
/// of a mistake in it: not TOML, a missing, unknown or repeated name, a wrong type, a number that
/// is not finite.
Case read_user_problem(const std::filesystem::path& file);

}  // namespace stiction
