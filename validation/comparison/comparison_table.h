// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/record/record.h"

namespace stiction {

/// One comparison as a table in Markdown that reads well on a terminal: a row a record (rule and
/// contacts), a column a measured figure, then what friction cost. `records` are those of one case.
std::string comparison_table(const std::vector<const Record*>& records);

/// Rows of cells, the first the headings, as a table in Markdown whose columns are aligned; the first
/// `texts` columns to the left, the others, numbers, to the right.
std::string aligned_table(const std::vector<std::vector<std::string>>& rows, std::size_t texts);

/// Letters on a terminal: bytes of UTF-8 but the continuing ones.
std::size_t letters(const std::string& text);

/// Wall-clock time of the friction phase per contact update, ns; 0 when not timed.
double friction_nanoseconds(const Record& record);

/// Value of the check of that quantity; NaN when there is none.
double figure(const Record& record, const std::string& quantity);

}  // namespace stiction
