// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "benchmarks/bench/features.h"
#include "benchmarks/bench/scaling.h"
#include "reports/record/record.h"

namespace stiction::bench {

/// One record a workload, with the checks that it is at rest and the time of each part; one a
/// family, with the exponents; one of the features, when they were measured. Environment included.
std::vector<Record> records_of(const Measure& measure, const std::vector<Scaling>& scalings,
                               const std::vector<FeatureCost>& features);

}  // namespace stiction::bench
