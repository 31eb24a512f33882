// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/frozen_step.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reference/statistics/nonlinear_system.h"

namespace stiction {
namespace {

ComparisonScene small_slab() {
  SlabSetup setup = comparison_slab();
  setup.cells = 2;
  return {.name = "test-slab",
          .title = "",
          .problem = slab_problem(setup),
          .settings = {{"cells", fmt::format("{}", setup.cells)}},
          .settled = 0.8,
          .size = setup.box_size.x()};
}

class FrozenSlab : public testing::Test {
 protected:
  FrozenStep frozen{find_engine("stiction"), small_slab(), "quiet"};
};

TEST_F(FrozenSlab, IsTheSameHoweverOftenItIsReplayed) {
  ASSERT_GE(frozen.contacts(), 8);
  const Eigen::VectorXd xi = frozen.learned();
  const FrozenStep::Slip first = frozen.slip_with(xi);
  frozen.slip_with(0.5 * xi);
  const FrozenStep::Slip again = frozen.slip_with(xi);
  EXPECT_EQ(first.along, again.along);
  EXPECT_EQ(first.across, again.across);
}

TEST_F(FrozenSlab, HasTheWholeFreeSlipWithoutFriction) {
  // ξ → 0: no friction is left, and u = ũ, which lies along itself.
  const FrozenStep::Slip slip =
      frozen.slip_with(Eigen::VectorXd::Constant(frozen.contacts(), 1e-9));
  EXPECT_LT((slip.along - slip.free).norm(), 1e-6 * slip.free.norm());
  EXPECT_LT(slip.across.norm(), 1e-6 * slip.free.norm());
}

TEST_F(FrozenSlab, IsSolvedByAVectorButNotByAScalarAContact) {
  const auto along = [&](const Eigen::VectorXd& xi) -> Eigen::VectorXd {
    return frozen.slip_with(xi).along;
  };
  const reference::SystemSolution root = reference::solve_system(along, frozen.learned(), 1e-14);
  EXPECT_LE(root.residual, 1e-14);
  EXPECT_GT(frozen.slip_with(root.x).across.norm(), 1e-6);
  const auto with_bias = [&](const Eigen::VectorXd& bias) -> Eigen::VectorXd {
    return frozen.slip_with_bias(bias);
  };
  const reference::SystemSolution bias =
      reference::solve_least_squares(with_bias, Eigen::VectorXd::Zero(2 * frozen.contacts()));
  EXPECT_LE(bias.residual, 1e-9);  // what counts as static
}

}  // namespace
}  // namespace stiction
