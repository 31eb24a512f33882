// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

/// Internal to limit analysis: linear programming in doubles. It knows nothing of contacts, and
/// its answers are worth nothing until limit_proofs.h has confirmed them. All numbers are
/// dimensionless, since the equations come scaled (limit_equations.h).
namespace stiction::reference {

/// Revised simplex in doubles:  min cᵀx,  A x = b,  x ≥ 0, with the inverse of the basis kept
/// dense. It only proposes, so it may stop anywhere: the certificates decide.
class Simplex {
 public:
  /// `a`: rows × columns, `b`: one entry a row. Rows are extended by ± slacks, which are the first
  /// basis. b is perturbed (deterministically, ≤ 1e-11) against cycling: equilibrium of moments
  /// makes most of it zero.
  Simplex(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

  /// Smallest Σ slacks: how far from feasible, and the mechanism that proves it.
  void minimise_residual();

  /// Largest x of `column`, from a feasible basis, slacks kept out.
  void maximise(Eigen::Index column);

  /// Basic solution of the unperturbed right side, negative round-off clipped; one entry a column.
  [[nodiscard]] Eigen::VectorXd solution() const;
  /// Dual variables y of the last objective, one entry a row.
  [[nodiscard]] Eigen::VectorXd multipliers() const;
  [[nodiscard]] int iterations() const { return iterations_; }  ///< pivots so far

 private:
  [[nodiscard]] Eigen::VectorXd basic_cost() const;

  /// Fresh inverse. A basis that turned out singular is given up for the last good one: false.
  bool refactor();

  bool pivot(Eigen::Index row, Eigen::Index column, const Eigen::VectorXd& direction);

  /// A slack that is basic at zero must not grow later: it leaves for any structural column.
  void expel_slacks();

  /// Pivots among the first `allowed` columns while that lowers the cost, up to a limit.
  void run(Eigen::Index allowed);

  Eigen::Index rows_;
  Eigen::Index columns_;
  Eigen::MatrixXd a_;
  Eigen::VectorXd b_, perturbed_, cost_, x_;
  Eigen::MatrixXd inverse_, good_inverse_;
  std::vector<Eigen::Index> basis_, good_basis_;
  int since_refactor_ = 0;
  int iterations_ = 0;
};

}  // namespace stiction::reference
