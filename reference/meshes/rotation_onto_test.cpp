// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/rotation_onto.h"

#include <gtest/gtest.h>

#include <limits>

namespace stiction::reference {
namespace {

using Eigen::Vector3d;

TEST(RotationOnto, IsThatOfEigen) {
  for (const Vector3d& from : {Vector3d(0, 1, 1), Vector3d(3, -2, 0.5), Vector3d(0, 0, 2)}) {
    for (const Vector3d& to : {Vector3d(0, 0, 1), Vector3d(0, 0, -1), Vector3d(-1, 2, 3)}) {
      if (from.normalized().dot(to.normalized()) < -0.999) continue;
      EXPECT_EQ(rotation_onto(from, to).coeffs(),
                Eigen::Quaterniond::FromTwoVectors(from, to).coeffs());
    }
  }
}

TEST(RotationOnto, IsAHalfTurnWhereTheyAreOpposite) {
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  const Vector3d from(1, -2, 0.3);
  const Eigen::Quaterniond half = rotation_onto(from, -from);
  EXPECT_LT((half * from + from).norm(), kRounding * from.norm());
  EXPECT_NEAR(half.norm(), 1.0, kRounding);
}

}  // namespace
}  // namespace stiction::reference
