// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/limit/limit_simplex.h"

#include <glpk.h>
#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <random>
#include <stdexcept>
#include <thread>

namespace stiction::reference {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// x + 2 y ≤ 4, 3 x + y ≤ 6 with slacks of its own, and x itself is the first column.
const MatrixXd kCorner{{1.0, 2.0, 1.0, 0.0}, {3.0, 1.0, 0.0, 1.0}};
const VectorXd kBounds{{4.0, 6.0}};

TEST(Simplex, FindsTheCorner) {  // analytic
  Simplex simplex(kCorner, kBounds);
  simplex.minimise_residual();
  EXPECT_LT((kCorner * simplex.solution() - kBounds).norm(), 1e-14);
  simplex.maximise(0);
  EXPECT_NEAR(simplex.solution()[0], 2.0, 1e-15);
  // c = −e_0: the second bound alone holds x back, by 1/3 a unit of it.
  EXPECT_NEAR(simplex.multipliers()[0], 0.0, 1e-15);
  EXPECT_NEAR(simplex.multipliers()[1], -1.0 / 3.0, 1e-15);
  EXPECT_GT(simplex.iterations(), 0);
}

TEST(Simplex, WhatHasNoSolutionHasAMechanism) {  // Farkas: yᵀA ≤ 0 < yᵀb
  const MatrixXd a{{1.0, 1.0}, {1.0, 1.0}};
  const VectorXd b{{1.0, 2.0}};
  Simplex simplex(a, b);
  simplex.minimise_residual();
  EXPECT_NEAR((a * simplex.solution() - b).lpNorm<1>(), 1.0, 1e-15);
  const VectorXd y = simplex.multipliers();
  EXPECT_LE((y.transpose() * a).maxCoeff(), 1e-15);
  EXPECT_NEAR(y.dot(b), 1.0, 1e-15);
}

/// Feasible by construction; `rows` × `columns` without zeros.
Simplex random_program(int rows, int columns) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const MatrixXd a = MatrixXd::NullaryExpr(rows, columns, [&] { return uniform(generator); });
  return {a, a * VectorXd::Ones(columns)};
}

TEST(Simplex, SaysNothingOnTheTerminal) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Simplex simplex = random_program(20, 60);
  simplex.minimise_residual();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Simplex, SolvesOnEveryThreadAtOnce) {
  std::atomic<int> solved = 0;
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k) {
    threads.emplace_back([&] {
      for (int round = 0; round < 20; ++round) {
        Simplex simplex(kCorner, kBounds);
        simplex.minimise_residual();
        simplex.maximise(0);
        if (std::abs(simplex.solution()[0] - 2.0) < 1e-15) ++solved;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(solved, 80);
}

// GLPK would end the program.
TEST(Simplex, AnErrorOfGlpkIsAnException) {
  ASSERT_EQ(glp_init_env(), 0);
  glp_mem_limit(1);
  Simplex simplex = random_program(100, 1000);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  try {
    simplex.minimise_residual();
    ADD_FAILURE() << "a megabyte was enough";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "simplex: GLPK gave up: glp_alloc: memory allocation limit exceeded");
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  simplex.minimise_residual();  // the limit is gone with what GLPK knew
  EXPECT_GT(simplex.iterations(), 0);
}

TEST(Simplex, LeavesACallersGlpkAlone) {
  ASSERT_EQ(glp_init_env(), 0);
  glp_prob* const own = glp_create_prob();
  glp_add_rows(own, 3);
  random_program(5, 9).minimise_residual();
  EXPECT_EQ(glp_get_num_rows(own), 3);
  glp_delete_prob(own);
  glp_free_env();
}

TEST(Simplex, RefusesWhatIsNotFinite) {
  MatrixXd a = kCorner;
  a(1, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Simplex(a, kBounds), std::invalid_argument);
  EXPECT_THROW(Simplex(kCorner, VectorXd::Constant(2, std::numeric_limits<double>::infinity())),
               std::invalid_argument);
}

}  // namespace
}  // namespace stiction::reference
