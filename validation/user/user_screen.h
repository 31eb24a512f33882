// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "validation/core/runner.h"
#include "validation/user/user_case.h"

namespace stiction {

/// Shows what each problem is, in words, and about how long it takes on the engine of its job; simulates
/// no more than a tenth of a second of it. Writes `out`/check-only/problems.json for who draws them, and
/// tells that folder to the script that called. Throws InputError for what cannot run.
void show_problems(const std::vector<UserCase>& problems, const std::vector<Job>& jobs,
                   const std::filesystem::path& out);

/// Tells on stderr about how long the problems take that take ten seconds and more.
void tell_long_runs(const std::vector<UserCase>& problems, const std::vector<Job>& jobs);

}  // namespace stiction
