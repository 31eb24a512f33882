// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"
#include "reports/screen/screen.h"

namespace stiction {

/// The end of a run on one screen, of 24 or more lines where it says its height: who holds, who creeps,
/// how accurately, at what cost, and why what falls short does. What fails stands in it by name, and
/// whole in failure_block(). `wall_seconds`: how long the run took, s; 0: not known.
std::string summary_screen(const std::vector<Record>& records, const Screen& screen,
                           double wall_seconds = 0.0);

}  // namespace stiction
