// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/record/record.h"
#include "reports/screen/screen.h"

namespace stiction {

/// The part of the summary screen about what falls short as expected: records by what their worst
/// check's cause comes down to, each with a family. At most `most` lines below its heading; empty
/// where nothing does.
std::string why_short(const std::vector<Record>& records, std::size_t most, const Screen& screen);

}  // namespace stiction
