// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/shared_run.h"

#include <gtest/gtest.h>

#include "validation/problems/slopes/incline_problem.h"

namespace stiction {
namespace {

struct Variants {
  Case which{.name = "shared", .title = "t"};
  SharedRun<double> shared;
  int computed = 0;

  Record record(const Settings& settings, const Settings& over) {
    CaseRun run(which, find_engine("stiction"), settings, 1.0);
    shared.get(run, over, [&](CaseRun& part) {
      ++computed;
      const auto simulation = part.simulate(incline_problem(InclineSetup{}));
      simulation->advance(3);
      return simulation->time();
    });
    return run.record();
  }
};

TEST(SharedRun, IsComputedOnceAndPaidOnce) {
  Variants variants;
  const Record first = variants.record({{"rule", "none"}}, {{"rule", "fixed-point"}});
  const Record second = variants.record({{"rule", "stored-vector"}}, {{"rule", "fixed-point"}});
  EXPECT_EQ(variants.computed, 1);
  EXPECT_EQ(first.cost.steps, 3u);
  EXPECT_EQ(second.cost.steps, 0u);
}

TEST(SharedRun, IsComputedAnewForOtherSettings) {
  Variants variants;
  variants.record({{"rule", "none"}, {"dt", "1e-4"}}, {{"rule", "fixed-point"}});
  variants.record({{"rule", "none"}, {"dt", "2e-4"}}, {{"rule", "fixed-point"}});
  EXPECT_EQ(variants.computed, 2);
}

}  // namespace
}  // namespace stiction
