// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "validation/core/case.h"
#include "validation/user/user_problem.h"

namespace stiction {

/// A person's own problem as a case.
struct UserCase {
  Case which{};
  std::shared_ptr<const UserProblem> problem{};  ///< null: a body of it could not be meshed
  std::string error{};                           ///< why; the case ends with it
};

/// Reads files as cases "user/STEM"; where two have one stem, as many of their folders stand before
/// it as tell them apart. Throws InputError with one sentence that names the file, and the line of a
/// mistake in it; for a file that is given twice too.
std::vector<UserCase> read_user_problems(const std::vector<std::string>& files);

/// One of them.
Case read_user_problem(const std::filesystem::path& file);

}  // namespace stiction
