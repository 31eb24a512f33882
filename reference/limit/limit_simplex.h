// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <vector>

/// Internal to limit analysis: linear programming in doubles, by GLPK [GLPK]. It knows nothing of
/// contacts, and its answers are worth nothing until limit_proofs.h has confirmed them. All numbers
/// are dimensionless, since the equations come scaled (limit_equations.h).
namespace stiction::reference {

/// GLPK's primal simplex:  min cᵀx,  A x = b,  x ≥ 0. Of what it finds the basis alone is taken;
/// solution and multipliers are solved from that anew, to round-off. It only proposes, so it may
/// stop anywhere: the certificates decide. Nothing of GLPK reaches the terminal, and none of its
/// errors ends the program.
class Simplex {
 public:
  /// `a`: rows × columns, `b`: one entry a row. Rows are extended by ± slacks, which are the first
  /// basis. Throws std::invalid_argument unless all entries are finite.
  Simplex(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

  /// Smallest Σ slacks: how far from feasible, and the mechanism that proves it. Throws
  /// std::runtime_error where GLPK gives up altogether, as without memory (so does `maximise`).
  void minimise_residual();

  /// Largest x of `column`, from a feasible basis, slacks kept out.
  void maximise(Eigen::Index column);

  /// Basic solution, negative round-off clipped; one entry a column.
  [[nodiscard]] Eigen::VectorXd solution() const;
  /// Dual variables y of the last objective, one entry a row.
  [[nodiscard]] Eigen::VectorXd multipliers() const;
  [[nodiscard]] int iterations() const { return iterations_; }  ///< pivots so far

 private:
  void run(bool with_slacks);
  /// The last basis stands where this one is none.
  void adopt(std::vector<Eigen::Index> basis);

  Eigen::Index rows_;
  Eigen::Index columns_;
  Eigen::MatrixXd a_;  // with slacks: rows × (columns + 2 rows)
  Eigen::VectorXd b_, cost_;
  // Entries that are not zero, numbered from 1, as GLPK wants them.
  std::vector<int> row_of_, column_of_;
  std::vector<double> entry_;
  std::vector<Eigen::Index> basis_;  // columns of a_, one a row
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
  int iterations_ = 0;
};

}  // namespace stiction::reference
