// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/formats/table.h"
#include "reports/record/record.h"

namespace stiction {

/// What records do not tell of their run.
struct RunFacts {
  double wall_seconds = 0.0;  ///< s; 0: not known
  std::size_t height = 0;     ///< lines to get by with, if it can be; 0: any number
};

/// The end of a run on one screen of 24 or more lines: who holds, who creeps, how accurately, at what
/// cost, and why what falls short does. What fails stands in it by name, and whole in failure_block().
std::string summary_screen(const std::vector<Record>& records, const TableStyle& style,
                           const RunFacts& facts = {});

/// What went wrong with one record, whole: the failing checks with worst offender and tolerance's
/// reason, its notes, and the command that runs it again. Empty for a record that neither fails nor
/// broke off.
std::string failure_block(const Record& record, const TableStyle& style,
                          const std::string& rerun = "");

}  // namespace stiction
