// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reports/screen/screen.h"
#include "validation/sweep/points.h"

namespace stiction {

/// What --dry-run prints: axes, number of points, some of them with their hash, and about how long all
/// of them take on so many cores, from the first steps of a few.
std::string dry_run_screen(const Study& study, const Points& points, int jobs,
                           const Screen& screen);

}  // namespace stiction
