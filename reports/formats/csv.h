// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/record/record.h"

namespace stiction {

/// CSV after RFC 4180 (comma, CRLF, quotes doubled; UTF-8) with a header row and one row per check.
/// A record without checks has one row with the check's columns empty, so that an error or a case
/// that does not apply is not lost. Numbers are written so that they read back exactly; NaN is
/// "nan". Words are one line; those that begin like a formula (= + - @) have "'" before them.
/// Column names are the fields of reports/record/schema.md; a check's verdict and error are
/// `verdict` and `error`, its record's `case_verdict` and `case_error`.
std::string csv_table(const std::vector<Record>& records);

/// A cell of words, guarded as above.
std::string csv_words(std::string_view text);

/// Cells as a row, with its line's end.
std::string csv_row(const std::vector<std::string>& cells);

}  // namespace stiction
