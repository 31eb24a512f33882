// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"

namespace stiction {

/// The report in GitHub-flavoured Markdown, from records alone: summary and environment, what
/// failed, then the case families. Within a family, checks with the same claim, formula, kind and
/// source share one table under them; equal tolerance reasons and notes are written once. Costs
/// follow.
std::string markdown_report(const std::vector<Record>& records,
                            const std::string& title = "stiction validation report");

}  // namespace stiction
