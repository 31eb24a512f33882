// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "reports/record/record_store.h"
#include "validation/sweep/results.h"

namespace stiction {

/// Takes the study's points that are finished in some run of these folders, of whatever study or
/// shard, into the store and the results, and says how many they are. With `retry` not those that
/// broke off. A line that a kill has cut off is no point. Throws std::runtime_error for a file that
/// cannot be read, or holds what is no record.
std::size_t take_over(const std::vector<std::filesystem::path>& folders, RecordStore& store,
                      const Points& points, bool retry, Results& results);

}  // namespace stiction
