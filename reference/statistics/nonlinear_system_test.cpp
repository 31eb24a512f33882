// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/statistics/nonlinear_system.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stiction::reference {
namespace {

// Rosenbrock's equations: root (1, 1).
Eigen::VectorXd rosenbrock(const Eigen::VectorXd& x) {
  return Eigen::Vector2d(1.0 - x(0), 10.0 * (x(1) - x(0) * x(0)));
}

TEST(NonlinearSystem, FindsTheRootOfRosenbrocksEquations) {
  const SystemSolution found = solve_system(rosenbrock, Eigen::Vector2d(-1.2, 1.0), 1e-13);
  EXPECT_EQ(found.outcome, "success");
  EXPECT_LE(found.residual, 1e-13);
  // The Jacobian's smallest singular value at the root is 0.45.
  EXPECT_LT((found.x - Eigen::Vector2d(1.0, 1.0)).norm(), 1e-12);
}

TEST(NonlinearSystem, SaysSoWhereThereIsNoRoot) {
  const auto no_root = [](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, 1.0 + x(0) * x(0));
  };
  const SystemSolution found = solve_system(no_root, Eigen::VectorXd::Constant(1, 2.0), 1e-12);
  EXPECT_NE(found.outcome, "success");
  EXPECT_GE(found.residual, 1.0);
  EXPECT_LE(found.residual, 5.0);
}

TEST(NonlinearSystem, SaysSoWhenItRanOutOfIterations) {
  const SystemSolution found = solve_system(rosenbrock, Eigen::Vector2d(-1.2, 1.0), 1e-13, 2);
  EXPECT_EQ(found.iterations, 2);
  EXPECT_NE(found.outcome, "success");
}

TEST(NonlinearSystem, RefusesASystemWithoutUnknowns) {
  EXPECT_THROW(solve_system(rosenbrock, Eigen::VectorXd(), 1e-12), std::invalid_argument);
}

TEST(LeastSquares, OfALinearProblemIsItsNormalEquations) {
  Eigen::MatrixXd a(3, 2);
  a << 1, 0, 0, 1, 1, 1;
  const Eigen::Vector3d b(1, 2, 4);
  const auto residual = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return a * x - b; };
  const SystemSolution found = solve_least_squares(residual, Eigen::Vector2d::Zero());
  EXPECT_LT((found.x - Eigen::Vector2d(4.0 / 3.0, 7.0 / 3.0)).norm(), 1e-9);
  EXPECT_NEAR(found.residual, 1.0 / 3.0, 1e-9);
}

// Two unknowns that act alike: as many solutions as one likes, and no failure.
TEST(LeastSquares, CopesWithRedundantUnknowns) {
  const auto residual = [](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return Eigen::Vector2d(x(0) + x(1) - 3.0, 2.0 * (x(0) + x(1)) - 6.0);
  };
  EXPECT_LT(solve_least_squares(residual, Eigen::Vector2d::Zero()).residual, 1e-9);
}

TEST(LeastSquares, RefusesFewerResidualsThanUnknowns) {
  const auto one = [](const Eigen::VectorXd&) -> Eigen::VectorXd {
    return Eigen::VectorXd::Zero(1);
  };
  EXPECT_THROW(solve_least_squares(one, Eigen::Vector2d::Zero()), std::invalid_argument);
}

TEST(Jacobian, OfALinearSystemIsItsMatrix) {
  Eigen::Matrix2d a;
  a << 1, 2, 3, 4;
  const auto f = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return a * x; };
  // Round-off of the values, about 1e-15, over the step.
  EXPECT_LT((jacobian_of(f, Eigen::Vector2d(0.3, -0.2), 1e-3) - a).norm(), 1e-11);
}

TEST(Jacobian, DominanceIsThatOfTheWorstRow) {
  Eigen::Matrix2d a;
  a << 4, -1, 3, 6;
  EXPECT_EQ(diagonal_dominance(a), 2.0);
  EXPECT_EQ(diagonal_dominance(Eigen::Matrix2d::Identity()),
            std::numeric_limits<double>::infinity());
  EXPECT_THROW(diagonal_dominance(Eigen::MatrixXd::Zero(2, 3)), std::invalid_argument);
}

TEST(SpectralRadius, CountsComplexEigenvaluesByTheirModulus) {
  Eigen::Matrix2d turn;
  turn << 0, -2, 2, 0;  // ± 2i
  EXPECT_NEAR(spectral_radius(turn), 2.0, 1e-14);
  Eigen::Matrix3d triangular;
  triangular << 0.5, 7, 1, 0, -3, 2, 0, 0, 1;
  EXPECT_NEAR(spectral_radius(triangular), 3.0, 1e-14);
}

}  // namespace
}  // namespace stiction::reference
