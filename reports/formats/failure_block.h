// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"
#include "reports/screen/screen.h"

namespace stiction {

/// What went wrong with one record, whole: the failing checks with worst offender and tolerance's
/// reason, its notes, and the command that runs it again (`rerun`, or what the record tells). Empty for
/// a record that neither fails nor broke off.
std::string failure_block(const Record& record, const Screen& screen,
                          const std::string& rerun = "");

/// The first of those that fail by name, a line or two each with what is worst, and how many more.
std::string failing_lines(const std::vector<Record>& records, const Screen& screen);

}  // namespace stiction
