// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/record/record.h"

namespace stiction {

/// How a table is drawn on a terminal or into a file.
struct TableStyle {
  std::size_t width = 100;  ///< terminal columns; below 77 lines grow longer than asked for
  bool colour = false;      ///< ANSI colours; nothing is said by colour alone
};

/// Two heading lines: for a record's own line and for its checks' lines. Ends with a line break.
std::string table_header(const TableStyle& style);

/// One record: a line with its case name, settings and ns per contact update (contact phases only),
/// then a line per check. With an error, or without any check, a line says why instead.
std::string table_rows(const Record& record, const TableStyle& style);

/// The end of a run: counts, cost, and for every record that fails or could not run the failing
/// checks with worst offender, tolerance's reason and notes.
std::string closing_summary(const std::vector<Record>& records, const TableStyle& style);

}  // namespace stiction
