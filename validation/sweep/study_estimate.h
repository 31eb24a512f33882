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

/// What a scheduler asks for, as a JSON object: study, points, engines, cpu_seconds (null where no
/// point that was tried can run), memory_mib of a process that holds all points.
std::string dry_run_json(const Study& study, const Points& points);

}  // namespace stiction
