// SPDX-License-Identifier: BSD-3-Clause
#include "solver/parallel/team.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cfenv>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "solver/testing/test_refusal.h"

namespace stiction {
namespace {

// Work of which other threads take a part, however late they wake: the first piece waits for it.
template <class Work>
void shared_work(const Team& team, const Work& work) {
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<bool> helped = false;
  for_each(&team, 1000, [&](std::size_t k) {
    if (std::this_thread::get_id() == caller) {
      while (!helped) std::this_thread::yield();
    }
    work(k);
    if (std::this_thread::get_id() != caller) helped = true;
  });
}

class TeamOfMany : public testing::Test {
 protected:
  void SetUp() override {
    if (most_threads() == 1) GTEST_SKIP() << "built without oneTBB";
    if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "one core: nobody helps";
  }
};

TEST_F(TeamOfMany, DoesEachPieceOnce) {
  const Team team(2);
  std::vector<std::atomic<int>> done(1000);
  shared_work(team, [&](std::size_t k) { ++done[k]; });
  for (const auto& times : done) EXPECT_EQ(times, 1);
  EXPECT_GT(team.helpers_cpu_seconds(), 0.0);
}

// What lies together stays in one thread's cache, work after work.
TEST_F(TeamOfMany, GivesEachThreadAPartOfItsOwn) {
  const Team team(2);
  const std::thread::id caller = std::this_thread::get_id();
  constexpr std::size_t kPieces = 64;
  for (int round = 0; round < 20; ++round) {
    std::vector<char> by_caller(kPieces);
    std::atomic<std::size_t> first_of_helper = kPieces;
    std::atomic<bool> caller_came = false;
    for_each(&team, kPieces, [&](std::size_t k) {
      const bool calls = std::this_thread::get_id() == caller;
      by_caller[k] = calls;
      if (calls) {
        caller_came = true;
      } else {
        std::size_t none = kPieces;
        first_of_helper.compare_exchange_strong(none, k);
      }
      // Until both have come, however late.
      while (!caller_came || first_of_helper == kPieces) std::this_thread::yield();
    });
    EXPECT_EQ(first_of_helper, kPieces / 2);
    EXPECT_TRUE(by_caller[0]);
    // Each goes on from its first, and who is done takes from the end of what the other has left.
    const auto changes = [&] {
      std::size_t count = 0;
      for (std::size_t k = 1; k < kPieces; ++k) count += by_caller[k] != by_caller[k - 1];
      return count;
    }();
    EXPECT_LE(changes, 2u);
  }
}

TEST_F(TeamOfMany, ComputesWithTheRoundingModeOfTheCaller) {
  const Team team(2);
  shared_work(team, [](std::size_t) {});  // its threads have begun with the usual mode
  std::fesetround(FE_UPWARD);
  std::atomic<int> others = 0;
  shared_work(team, [&](std::size_t) {
    const volatile double one = 1.0, three = 3.0;
    others += !(one / three > 1.0 / 3.0);  // which the compiler has rounded to the nearest
  });
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(others, 0);
}

TEST_F(TeamOfMany, TellsTheCallerWhichExceptionsOfArithmeticWereRaised) {
  const Team team(2);
  const std::thread::id caller = std::this_thread::get_id();
  std::feclearexcept(FE_ALL_EXCEPT);
  shared_work(team, [&](std::size_t) {
    if (std::this_thread::get_id() != caller) std::feraiseexcept(FE_DIVBYZERO);
  });
  EXPECT_NE(std::fetestexcept(FE_DIVBYZERO), 0);
  EXPECT_EQ(std::fetestexcept(FE_INVALID), 0);
  std::feclearexcept(FE_ALL_EXCEPT);
}

TEST_F(TeamOfMany, ThrowsWhatAPieceThrew) {
  const Team team(2);
  EXPECT_THROW(for_each(&team, 100,
                        [](std::size_t k) {
                          if (k == 57) throw std::runtime_error("57");
                        }),
               std::runtime_error);
}

TEST_F(TeamOfMany, GoesOnAfterAPieceThrew) {
  const Team team(2);
  for (int round = 0; round < 100; ++round) {
    EXPECT_THROW(for_each(&team, 8, [](std::size_t) { throw std::runtime_error("each"); }),
                 std::runtime_error);
    std::atomic<std::size_t> sum = 0;
    for_each(&team, 8, [&](std::size_t k) { sum += k; });
    EXPECT_EQ(sum, 28u);
  }
}

TEST_F(TeamOfMany, HasWorkWithinWork) {
  const Team team(2);
  for (int round = 0; round < 1000; ++round) {
    std::atomic<int> done = 0;
    for_each(&team, 8, [&](std::size_t) { for_each(&team, 8, [&](std::size_t) { ++done; }); });
    ASSERT_EQ(done, 64);
  }
}

// Helpers come and go while work is opened and closed, and what they see is of this work alone.
TEST_F(TeamOfMany, DoesEachPieceOnceInMuchWorkAfterAnother) {
  for (int teams = 0; teams < 20; ++teams) {
    const Team team(2);
    std::vector<int> done(64);
    for (int round = 1; round <= 2000; ++round) {
      const std::size_t count = 1 + static_cast<std::size_t>(round) % done.size();
      for_each(&team, count, [&done, round](std::size_t k) { done[k] += round; });
      for (std::size_t k = 0; k < count; ++k) {
        ASSERT_EQ(done[k], round) << k;
        done[k] = 0;
      }
    }
  }
}

TEST_F(TeamOfMany, IsHelpedAgainAfterItsThreadsHaveSlept) {
  const Team team(2);
  for (int round = 0; round < 5; ++round) {
    shared_work(team, [](std::size_t) {});  // never returns when nobody helps
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

// Who looks out for work of one team does not keep another from ending alone.
TEST_F(TeamOfMany, EndsBesideAnotherThatKeepsTheHelpers) {
  const Team first(2);
  shared_work(first, [](std::size_t) {});
  for (int round = 0; round < 50; ++round) {
    std::atomic<int> done = 0;
    const Team second(2);
    for_each(&first, 4, [](std::size_t) {});
    for_each(&second, 4, [&](std::size_t) { ++done; });
    EXPECT_EQ(done, 4);
  }
}

TEST(Team, RefusesNumbersOfThreadsThatAreNone) {
  for (const int threads : {0, -3, 100000}) {
    const std::string said = test::refusal([&] { const Team team(threads); });
    EXPECT_NE(said.find("not " + std::to_string(threads)), std::string::npos) << said;
  }
}

TEST(Team, HasTheNumberOfThreadsOfTheEnvironment) {
  EXPECT_EQ(chosen_step_threads(""), 1);
  EXPECT_EQ(chosen_step_threads("1"), 1);
  for (const char* wanted : {"0", "-2", "two", "2x", " 2", "1e9", "99999999999999999999"}) {
    const std::string said = test::refusal([&] { chosen_step_threads(wanted); });
    EXPECT_NE(said.find(std::string("'") + wanted + "'"), std::string::npos) << said;
  }
}

TEST_F(TeamOfMany, IsWhatTheEnvironmentAsksFor) { EXPECT_EQ(chosen_step_threads("2"), 2); }

TEST(Team, OfOneGoesThroughRangesAtOnce) {
  const Team alone(1);
  for (const Team* team : {static_cast<const Team*>(nullptr), &alone}) {
    std::vector<std::pair<std::size_t, std::size_t>> ranges;
    for_ranges(team, 10000, 10,
               [&](std::size_t begin, std::size_t end) { ranges.emplace_back(begin, end); });
    ASSERT_EQ(ranges.size(), 1u);
    EXPECT_EQ(ranges[0], std::pair(std::size_t{0}, std::size_t{10000}));
  }
}

TEST_F(TeamOfMany, RangesMakeUpTheWhole) {
  const Team team(3);
  for (const std::size_t count : {0u, 1u, 19u, 20u, 1003u}) {
    std::vector<std::atomic<int>> seen(count);
    for_ranges(&team, count, 10, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) ++seen[k];
    });
    for (const auto& times : seen) EXPECT_EQ(times, 1);
  }
  EXPECT_EQ(ranges_of(&team, 19, 10), 1u);
  EXPECT_EQ(ranges_of(&team, 20, 10), 2u);
  EXPECT_EQ(ranges_of(&team, 1000, 10), 24u);
}

}  // namespace
}  // namespace stiction
