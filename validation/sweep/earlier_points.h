// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "reports/record/record_store.h"
#include "validation/shards/parts.h"
#include "validation/sweep/results.h"

namespace stiction {

/// The records of every run in a study's own folder, which may not be there yet, and in others. Throws
/// InputError for another that is not there.
std::set<std::filesystem::path> record_files(const std::filesystem::path& own,
                                             const std::vector<std::string>& others);

/// Takes those of the study's points `own` that are finished in these files, of whatever study or shard,
/// into the store and the results, in their order, and says how many they are. With `retry` not those
/// that broke off. Of a point that was computed more than once a result goes before one that broke
/// off, and then the newest. A line that a kill has cut off is no point, nor is one that is damaged, which
/// is told.
std::size_t take_over(const std::set<std::filesystem::path>& files, RecordStore& store,
                      const Points& points, const std::vector<std::size_t>& own, bool retry,
                      Results& results);

/// Takes all points from the parts of this study into the store and the results, in order.
std::size_t take_parts(const Parts& parts, RecordStore& store, const Points& points,
                       Results& results);

}  // namespace stiction
