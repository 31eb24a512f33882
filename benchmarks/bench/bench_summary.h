// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/bench/features.h"
#include "benchmarks/bench/measure.h"
#include "benchmarks/bench/scaling.h"
#include "reports/record/record.h"
#include "reports/screen/screen.h"

namespace stiction::bench {

/// What was measured on one screen: what a contact costs in each family and size and how that grows,
/// friction rule by rule with its error, what features cost those who leave them, and what was not at
/// rest, with the command that measures it again. Of a few benchmarks chosen by name each is told.
std::string bench_summary(const std::vector<Result>& results, const std::vector<Scaling>& fits,
                          const std::vector<FeatureCost>& features,
                          const std::vector<Record>& records, const Screen& screen);

}  // namespace stiction::bench
