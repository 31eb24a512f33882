// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "validation/core/runner.h"
#include "validation/shards/shard.h"

namespace stiction {

/// A row of the committed table case_costs.cpp, which case_costs.py writes from records.
struct CaseCost {
  const char* case_name;
  const char* configuration;
  double cpu_seconds;
};
std::span<const CaseCost> case_costs();

/// Whether jobs of one case stay in one part, as they may share simulations.
enum class Together { kCases, kNothing };

/// About how much CPU time each job takes, s: what the table has of its case and configuration; of its
/// case; of its family; else the table's median. Another engine's jobs are as dear beside each other
/// as this project's.
std::vector<double> estimated_seconds(const std::vector<Job>& jobs);

/// The order in which so many threads begin jobs that take so long, s: theirs, but one that would go on
/// alone after all others behind it is begun sooner, when what is left takes the threads no longer.
std::vector<std::size_t> order_to_begin(const std::vector<double>& seconds, int threads);

/// The jobs of a shard, in order, balanced by what they cost.
std::vector<std::size_t> jobs_of(const Shard& shard, const std::vector<Job>& jobs,
                                 Together together);

}  // namespace stiction
