// SPDX-License-Identifier: BSD-3-Clause
#include "solver/real.h"

#include <gtest/gtest.h>

namespace stiction {
namespace {

// These tests are built in double precision, where each threshold must be what is written.
static_assert(std::is_same_v<Real, double>);

TEST(Real, LeavesTheThresholdsOfDoublePrecisionAsTheyAreWritten) {
  for (const double written : {1e-15, 1e-14, 1e-12, 4e-12, 1e-9}) {
    EXPECT_EQ(round_off(written), written);
    EXPECT_EQ(by_precision(written, 1e-5), written);
  }
}

}  // namespace
}  // namespace stiction
