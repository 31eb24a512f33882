// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/lasting.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace stiction {
namespace {

// Of so many steps, in which paths grow by 1 m each and nothing changes, those in which it was not known, and
// those in which it was asked for how long, of answers of `within` m.
struct Counted {
  int unknown = 0, asked = 0;

  Counted(int steps, double within) {
    std::int8_t same = 0;
    double until = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < steps; ++k) {
      if (k < until) continue;
      ++unknown;
      note_lasting(true, k, same, until, [&] {
        ++asked;
        return within;
      });
    }
  }
};

TEST(Lasting, IsAskedAfterAFewSteps) {
  const Counted counted(1040, 100.5);
  EXPECT_EQ(counted.asked, 10);
  EXPECT_EQ(counted.unknown, 10 * kStepsToAsk);
}

TEST(Lasting, IsAskedSeldomWhereAnswersHoldForLessThanTheStepsBetween) {
  constexpr int kSteps = 720;
  for (const double within : {-1.0, 0.0, 0.5, 1.5}) {
    EXPECT_LE(Counted(kSteps, within).asked, 2 * kSteps / (2 * kStepsToAsk + kStepsToPause) + 1)
        << within;
  }
}

TEST(Lasting, IsForgottenWhereAnythingChanges) {
  std::int8_t same = 0;
  double until = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < kStepsToAsk; ++k) note_lasting(true, k, same, until, [] { return 1000.0; });
  EXPECT_GT(until, 1000.0);
  note_lasting(false, 2000.0, same, until, [] { return 0.0; });
  EXPECT_LT(until, 0.0);
}

}  // namespace
}  // namespace stiction
