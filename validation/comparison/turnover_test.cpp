// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/turnover.h"

#include <gtest/gtest.h>

namespace stiction {
namespace {

ContactSample touch(std::int64_t point, std::int64_t facet, double normal_force = 1.0,
                    std::size_t obstacle = 0) {
  return {.obstacle = obstacle,
          .point = point,
          .facet = facet,
          .normal = Vec3::UnitZ(),
          .normal_force = normal_force,
          .friction_force = Vec3::Zero(),
          .slip = Vec3::Zero()};
}

TEST(Turnover, CountsLossesAndChangesOfFacetFromStepToStep) {
  Turnover turnover;
  EXPECT_EQ(turnover.mean_loaded(), 0.0);
  turnover.add({touch(1, 10), touch(2, 20), touch(3, 30), touch(3, 31, 1.0, 7)});
  EXPECT_EQ(turnover.losses() + turnover.facet_changes(), 0u) << "nothing went before";
  // 1 changes to a lower facet, 2 is open, 3 changes to a higher one of one obstacle and leaves the
  // other; 4 is new.
  turnover.add({touch(4, 40), touch(3, 33), touch(2, 20, 0.0), touch(1, 9)});
  EXPECT_EQ(turnover.facet_changes(), 2u);
  EXPECT_EQ(turnover.losses(), 2u);
  turnover.add({touch(1, 9), touch(2, 20), touch(3, 33), touch(4, 40)});
  EXPECT_EQ(turnover.facet_changes(), 2u) << "2 had no load in between";
  EXPECT_EQ(turnover.losses(), 2u);
  turnover.add({});
  EXPECT_EQ(turnover.losses(), 6u);
  EXPECT_EQ(turnover.mean_loaded(), (4 + 3 + 4 + 0) / 4.0);
}

}  // namespace
}  // namespace stiction
