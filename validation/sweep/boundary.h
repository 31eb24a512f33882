// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"
#include "reports/screen/screen.h"
#include "validation/sweep/results.h"

namespace stiction {

/// What the points say of a study's boundary: a record an engine and case whose points are all known, none
/// without [boundary]. Its check is the point of the wrong outcome that lies farthest beyond the expected
/// boundary, as a signed distance along the axis: above 0 one that holds and must fail (for
/// holds = "above" the other way round), 0 when no outcome is wrong. A point on the boundary itself
/// is none. No number, so that it fails, where a point broke off, or where one side has no outcome.
std::vector<Record> boundary_records(const Study& study, const Points& points,
                                     const Results& results);

/// For people: a line a record.
std::string boundary_screen(const std::vector<Record>& boundaries, const Screen& screen);

}  // namespace stiction
