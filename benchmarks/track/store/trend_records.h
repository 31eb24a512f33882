// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "benchmarks/track/store/history.h"
#include "reports/record/record.h"

namespace stiction::track {

/// The history as records that the report page draws: a case "trend/<subject>" for each subject,
/// with a series over the runs ("run", numbered by their ids) for each of its metrics.
/// `environment` is that of the program that writes them.
std::vector<Record> trend_records(const std::vector<Trend>& trends, const Environment& environment);

}  // namespace stiction::track
