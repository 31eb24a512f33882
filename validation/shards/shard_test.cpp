// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/shards/shard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>

#include "solver/testing/test_refusal.h"

namespace stiction {
namespace {

using testing::HasSubstr;

// With these variables, and none of the others that name a shard.
Shard shard_in(const std::map<std::string, std::string>& environment) {
  for (const char* name : {"GTEST_SHARD_INDEX", "GTEST_TOTAL_SHARDS", "SLURM_ARRAY_TASK_ID",
                           "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN"}) {
    unsetenv(name);
  }
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  const auto clear = [&] {
    for (const auto& [name, value] : environment) unsetenv(name.c_str());
  };
  try {
    const Shard shard = shard_from("");
    clear();
    return shard;
  } catch (...) {
    clear();
    throw;
  }
}

TEST(Shards, AreNamedByWordsOrByTheEnvironment) {
  EXPECT_EQ(shard_from("2/8").number, 2u);
  EXPECT_EQ(shard_from("2/8").count, 8u);
  EXPECT_EQ(shard_in({}).count, 1u);
  const Shard gtest = shard_in({{"GTEST_SHARD_INDEX", "0"}, {"GTEST_TOTAL_SHARDS", "3"}});
  EXPECT_EQ(gtest.number, 1u);
  EXPECT_EQ(gtest.count, 3u);
  // --array=1-4 and --array=0-3 are the same four shards.
  const Shard from_one = shard_in({{"SLURM_ARRAY_TASK_ID", "4"},
                                   {"SLURM_ARRAY_TASK_COUNT", "4"},
                                   {"SLURM_ARRAY_TASK_MIN", "1"}});
  EXPECT_EQ(from_one.number, 4u);
  const Shard from_none = shard_in({{"SLURM_ARRAY_TASK_ID", "3"},
                                    {"SLURM_ARRAY_TASK_COUNT", "4"},
                                    {"SLURM_ARRAY_TASK_MIN", "0"}});
  EXPECT_EQ(from_none.number, 4u);
}

TEST(Shards, ThatAreNoneAreRefused) {
  for (const char* words : {"0/4", "5/4", "1", "1/", "/4", "1/0", "-1/4", "1.5/4", "one/four"}) {
    EXPECT_THAT(test::refusal([&] { shard_from(words); }), HasSubstr("a shard is I/N")) << words;
  }
  EXPECT_THAT(test::refusal([] {
                shard_in({{"SLURM_ARRAY_TASK_ID", "7"},
                          {"SLURM_ARRAY_TASK_COUNT", "4"},
                          {"SLURM_ARRAY_TASK_MIN", "1"}});
              }),
              HasSubstr("SLURM_ARRAY_TASK_ID=7"));
}

TEST(Shards, HaveEachJobOnceAndAreAsDearAsTheOthers) {
  std::mt19937 random(1);
  std::lognormal_distribution<double> cost(0.0, 2.0);
  for (const std::size_t jobs : {0u, 1u, 7u, 200u}) {
    std::vector<double> costs(jobs);
    for (double& one : costs) one = cost(random);
    for (const std::size_t count : {1u, 2u, 5u, 9u}) {
      std::vector<int> seen(jobs, 0);
      double dearest = 0.0;
      for (std::size_t number = 1; number <= count; ++number) {
        double load = 0.0;
        for (const std::size_t job : jobs_of({number, count}, costs)) {
          ++seen[job];
          load += costs[job];
        }
        dearest = std::max(dearest, load);
      }
      EXPECT_THAT(seen, testing::Each(1));
      const double sum = std::accumulate(costs.begin(), costs.end(), 0.0);
      const double most = jobs > 0 ? *std::max_element(costs.begin(), costs.end()) : 0.0;
      // When the dearest shard took its last job, no other had less than it had then.
      EXPECT_LE(dearest, sum / static_cast<double>(count) + most + 1e-12);
    }
  }
}

}  // namespace
}  // namespace stiction
