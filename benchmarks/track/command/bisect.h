// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmarks/track/measure/campaign.h"

namespace stiction::track {

/// The revision that moved a metric.
struct Found {
  std::string commit;             ///< full id
  Comparison comparison;          ///< of the good revision with this one
  std::vector<std::string> also;  ///< revisions before it that could not be measured: it may be one
};

/// How a revision compares with the good one: moved, not moved, or nothing when it could not be
/// built or measured.
using Probe = std::function<std::optional<Comparison>(const std::string& commit)>;

/// First of `commits` (oldest first) whose metric differs from the good revision's, by halving:
/// it takes the metric to have moved once. Revisions that cannot be measured are stepped over.
/// Nothing when the last one has not moved. Throws TrackError when the last cannot be measured.
std::optional<Found> first_moved(const std::vector<std::string>& commits, const Probe& probe);

/// Builds and measures revisions between `good` and `bad` as needed. Only the metric's own subject
/// is measured. Throws TrackError for a metric that is in neither of the two; before anything is built
/// for one that neither the present tree nor the history knows.
std::optional<Found> bisect(const Project& project, const std::string& metric,
                            const std::string& good, const std::string& bad, const Scope& scope,
                            const std::filesystem::path& history);

/// The part of a scope that measures this metric: one benchmark's times or counts, or the cases.
/// Throws TrackError for a name that has no '#'.
Scope scope_of_metric(const std::string& metric, Scope scope);

}  // namespace stiction::track
