// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <istream>

#include "solver/demand.h"
#include "validation/user/user_run.h"

namespace stiction {

/// The mesher failed, not the file: costs this problem, not those beside it.
class NotMeshed : public InputError {
 public:
  using InputError::InputError;
};

/// The problem that a text describes (TOML; validation/user/examples/ramp.toml explains each key);
/// `file` is what messages call it, and where its relative paths start. Throws InputError with one
/// sentence that names the file, and the line of a mistake in it: not TOML, a missing, unknown or
/// repeated name, a wrong type, a number that is not finite.
UserProblem user_problem(std::istream& text, const std::filesystem::path& file);

}  // namespace stiction
