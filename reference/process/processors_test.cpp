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
  const double seconds = answer_seconds();
  if (before.size() > 1) {
    EXPECT_GT(seconds, 5e-9)
        << "there and back, as far as a third cache, which takes 10 ns or more";
    EXPECT_LT(seconds, 1e-3) << "less than the system lets a thread have a processor for";
  } else {
    EXPECT_EQ(seconds, 0.0) << "nobody answers";
  }
  EXPECT_EQ(own_processors(), before);
}

TEST(Processors, OfOneAloneThereIsNoAnswer) {
  const std::vector<int> before = own_processors();
  stay_on({before.front()});
  EXPECT_EQ(answer_seconds(), 0.0);
  stay_on(before);
}

TEST(Processors, TogetherTheyDoAsMuchAsOneOrMore) {
  const std::vector<int> before = own_processors();
  const auto count = static_cast<double>(before.size());
  // A neighbour may come or go while it is measured, for some milliseconds: seldom each time.
  bool seen = false;
  for (int tries = 0; !seen && tries < 100; ++tries) {
    const Together all = measure_together(static_cast<int>(before.size()));
    seen = all.arithmetic > 0.9 && all.arithmetic < 1.1 * count;
    EXPECT_EQ(all.answer_seconds > 0.0, before.size() > 1);
  }
  EXPECT_TRUE(seen);
  EXPECT_EQ(own_processors(), before);
}

TEST(Processors, AThreadAloneSharesNothing) {
  EXPECT_EQ(measure_together(1).arithmetic, 1.0);
  EXPECT_EQ(measure_together(1).answer_seconds, 0.0);
  const std::vector<int> before = own_processors();
  stay_on({before.front()});
  EXPECT_EQ(measure_together(2).arithmetic, 1.0);
  stay_on(before);
}

TEST(Processors, OfNoneNothingChanges) {
  const std::vector<int> before = own_processors();
  stay_on({});
  EXPECT_EQ(own_processors(), before);
}

}  // namespace
}  // namespace stiction::reference
