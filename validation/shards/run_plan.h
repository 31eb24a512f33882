// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "reports/record/record_store.h"
#include "validation/core/runner.h"
#include "validation/shards/shard.h"

namespace stiction {

/// What a run, or a part of it, sets out to do: run.json in its folder, from its beginning on, so that
/// parts can be put together and what is missing be told.
struct RunPlan {
  std::string program{};             ///< "validate", "compare" or "sweep"
  std::vector<std::string> words{};  ///< of its command, but which part, where to and how it runs
  std::string plan{};                ///< 16 hex digits, a hash of all jobs, whichever part has them
  std::size_t jobs = 0;              ///< of all parts
  Shard shard{};
};

/// Its file in a run's folder.
inline constexpr const char* kRunFile = "run.json";

void write_plan(RecordStore& store, const RunPlan& plan);
/// Throws std::runtime_error for what is no such file, in one sentence that names it.
RunPlan read_plan(const std::filesystem::path& file);

/// The words of a command line that say what is run: without those of which part, how, and what is
/// written (--shard, --jobs, --out, --lines …).
std::vector<std::string> words_of(int argc, const char* const* argv);

/// What the results depend on beside the jobs' own words: the suite's revision, of a changed tree the
/// program itself.
std::string revision_words();
/// An engine's name, and where it is a program what the files hold that its command names.
std::string engine_words(const EngineKind& engine);

/// A hash of the jobs in order, and of files and options (`more`) that they depend on.
std::string plan_of(const std::vector<Job>& jobs, const std::string& more);

}  // namespace stiction
