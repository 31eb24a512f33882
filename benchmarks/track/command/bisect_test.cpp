// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/command/bisect.h"

#include <gtest/gtest.h>

#include <set>

#include "benchmarks/track/measure/child.h"

namespace stiction::track {
namespace {

const std::vector<std::string> kCommits = {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"};

// Revisions from `moved` on are worse; those in `silent` cannot be measured. Counts its calls.
struct Revisions {
  int moved;
  std::set<int> silent{};
  int calls = 0;

  Probe probe() {
    return [this](const std::string& commit) -> std::optional<Comparison> {
      ++calls;
      const int k = std::stoi(commit);
      if (silent.contains(k)) return std::nullopt;
      Comparison one;
      one.change = k >= moved ? Change::kWorse : Change::kSame;
      one.after = k;
      return one;
    };
  }
};

TEST(Bisect, FindsEachRevision) {
  for (int moved = 0; moved < 10; ++moved) {
    Revisions revisions{moved};
    const auto found = first_moved(kCommits, revisions.probe());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->commit, std::to_string(moved));
    EXPECT_EQ(found->comparison.after, moved);
    EXPECT_TRUE(found->also.empty());
    EXPECT_LE(revisions.calls, 5);  // the last, and ⌈log₂ 10⌉
  }
}

TEST(Bisect, StepsOverWhatCannotBeMeasured) {
  for (int moved = 0; moved < 10; ++moved) {
    for (int silent = 0; silent < 9; ++silent) {
      Revisions revisions{moved, {silent, (silent + 1) % 9}};
      const auto found = first_moved(kCommits, revisions.probe());
      ASSERT_TRUE(found);
      // The true one is either found or named as possible.
      const std::string truth = std::to_string(moved);
      const bool named =
          std::find(found->also.begin(), found->also.end(), truth) != found->also.end();
      EXPECT_TRUE(found->commit == truth || named) << moved << " " << silent;
      EXPECT_EQ(named, revisions.silent.contains(moved));
    }
  }
}

TEST(Bisect, WhatHasNotMovedIsNotFound) {
  Revisions revisions{10};
  EXPECT_FALSE(first_moved(kCommits, revisions.probe()));
  EXPECT_EQ(revisions.calls, 1);
  EXPECT_FALSE(first_moved({}, revisions.probe()));
}

TEST(Bisect, TheLastMustBeMeasured) {
  Revisions revisions{3, {9}};
  EXPECT_THROW(first_moved(kCommits, revisions.probe()), TrackError);
}

TEST(Bisect, MeasuresOnlyWhatTheMetricNeeds) {
  const Scope time = scope_of_metric("friction:none/slab/contacts:1000#time", {});
  EXPECT_TRUE(time.times && !time.counts && !time.accuracy);
  EXPECT_EQ(time.benchmarks, std::vector<std::string>{"friction:none/slab/contacts:1000"});
  const Scope count = scope_of_metric("step/slab/contacts:1000#instructions", {});
  EXPECT_TRUE(!count.times && count.counts && !count.accuracy);
  const Scope digits = scope_of_metric("incline/creep@rule=none#digits: creep", {});
  EXPECT_TRUE(!digits.times && !digits.counts && digits.accuracy);
  EXPECT_EQ(digits.cases, (CaseOptions{"--full", "--case", "incline/creep"}));
  EXPECT_THROW(scope_of_metric("time", {}), TrackError);
}

}  // namespace
}  // namespace stiction::track
