// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/process/processors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reference/process/child.h"

namespace stiction::reference {
namespace {

using ::testing::Contains;

TEST(Processors, TheFastestIsOneOfThoseThatTheThreadMayRunOn) {
  const std::vector<int> before = own_processors();
  ASSERT_FALSE(before.empty());
  EXPECT_THAT(before, Contains(fastest_processor()));
  EXPECT_EQ(own_processors(), before);  // those that were tried are let go
}

TEST(Processors, WhatIsStartedMeanwhileStaysOnTheSameOne) {
  const std::vector<int> before = own_processors();
  {
    const OnFastestProcessor here;
    ASSERT_EQ(own_processors().size(), 1U);
    EXPECT_THAT(before, Contains(own_processors().front()));
    EXPECT_EQ(run_child({"nproc"}, {}).output, "1\n");
  }
  EXPECT_EQ(own_processors(), before);
}

TEST(Processors, AnAnswerOfAnotherTakesNanosecondsToMicroseconds) {
  const std::vector<int> before = own_processors();
  if (before.size() < 2) GTEST_SKIP() << "one processor: nobody answers";
  const double seconds = answer_seconds();
  EXPECT_GT(seconds, 5e-9) << "one writes a line of the cache that the other has";
  EXPECT_LT(seconds, 1e-3);
  EXPECT_EQ(own_processors(), before);
}

TEST(Processors, OfOneAloneThereIsNoAnswer) {
  const std::vector<int> before = own_processors();
  stay_on({before.front()});
  EXPECT_EQ(answer_seconds(), 0.0);
  stay_on(before);
}

TEST(Processors, OfNoneNothingChanges) {
  const std::vector<int> before = own_processors();
  stay_on({});
  EXPECT_EQ(own_processors(), before);
}

}  // namespace
}  // namespace stiction::reference
