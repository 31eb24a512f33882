// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stiction {

/// One of `count` parts of a run, which together are all of it, each job in one of them.
struct Shard {
  std::size_t number = 1;  ///< from 1 to count
  std::size_t count = 1;
};

inline constexpr std::size_t kMostShards = 1'000'000'000;

/// "2/8", the second of eight; empty: what the environment says, GTEST_SHARD_INDEX (from 0) of
/// GTEST_TOTAL_SHARDS, or SLURM_ARRAY_TASK_ID of SLURM_ARRAY_TASK_COUNT from SLURM_ARRAY_TASK_MIN on;
/// nothing there: all. Throws InputError.
Shard shard_from(const std::string& words);

/// The jobs of a shard, in order, of jobs that cost so much each (any unit, all above 0): the dearest
/// first to the shard that has least (Graham's rule: no shard has more than 4/3 of the best there
/// is). The same arguments give the same shards; a shard may be empty.
std::vector<std::size_t> jobs_of(const Shard& shard, const std::vector<double>& costs);

/// Of `jobs` jobs that are about as dear as their neighbours, or follow each other in a pattern: as many in
/// each shard, by lot, in order. The lot is the same on every machine.
std::vector<std::size_t> shuffled_share(const Shard& shard, std::size_t jobs);

}  // namespace stiction
