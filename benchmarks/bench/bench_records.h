// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "benchmarks/bench/features.h"
#include "benchmarks/bench/scaling.h"
#include "reports/record/record.h"

namespace stiction::bench {

/// Of a workload: the checks that it is at rest, and the time of each part. Environment included.
Record workload_record(const Measure::Settled& settled, const std::vector<Result>& results);

/// One a family, with the exponents; one of the features, when they were measured.
std::vector<Record> summary_records(const std::vector<Scaling>& scalings,
                                    const std::vector<FeatureCost>& features);

}  // namespace stiction::bench
