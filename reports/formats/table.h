// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"
#include "reports/screen/screen.h"

namespace stiction {

/// Below 77 columns lines grow longer than asked for.

/// Two heading lines: for a record's own line and for its checks' lines. Ends with a line break.
std::string table_header(const Screen& screen);

/// One record: a line with its case, configuration and ns per contact update (contact phases only),
/// then a line per check, or more where its name is long. With an error, or without any check, a
/// line says why instead.
std::string table_rows(const Record& record, const Screen& screen);

/// Of what is not applicable: why, and of which families how many records.
std::string not_applicable_block(const std::vector<Record>& records, const Screen& screen);

}  // namespace stiction
