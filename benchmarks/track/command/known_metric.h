// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "benchmarks/track/measure/campaign.h"

namespace stiction::track {

/// Demands, before anything is built, that there is a metric of this name: the present tree measures it,
/// or the history (which may be missing) holds it. Runs the metric's own case or counts its benchmark
/// where only that tells. `narrow` is the scope of the metric (scope_of_metric). Throws TrackError that
/// lists the metrics there are.
void demand_known(const Project& project, const std::string& metric, const Scope& narrow,
                  const std::filesystem::path& history);

}  // namespace stiction::track
