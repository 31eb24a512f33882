// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/record/record.h"
#include "reports/screen/screen.h"

namespace stiction {

/// Of cases that were perturbed (perturbed/*): for each perturbation the fewest digits that survive,
/// and in which case; those with the fewest first, `most` of them. Empty where none was.
std::string digits_survive(const std::vector<Record>& records, std::size_t most,
                           const Screen& screen);

/// Of ladders (ladder/*): up to where each holds, what breaks there, and which hold on every rung; `most`
/// of those that break. Empty where there is none.
std::string ladder_ends(const std::vector<Record>& records, std::size_t most, const Screen& screen);

}  // namespace stiction
