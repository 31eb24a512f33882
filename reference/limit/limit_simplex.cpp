// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/limit/limit_simplex.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

namespace stiction::reference {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Index = Eigen::Index;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPivot = 1e-7;  // a smaller entry is no pivot

}  // namespace

Simplex::Simplex(const MatrixXd& a, const VectorXd& b)
    : rows_(a.rows()), columns_(a.cols()), b_(b) {
  a_.resize(rows_, columns_ + 2 * rows_);
  a_ << a, MatrixXd::Identity(rows_, rows_), -MatrixXd::Identity(rows_, rows_);
  perturbed_ = b;
  unsigned state = 1;
  for (Index r = 0; r < rows_; ++r) {
    state = state * 1664525U + 1013904223U;
    const double amount = 1e-11 * (0.5 + static_cast<double>(state >> 8U) / 33554432.0);
    perturbed_[r] += b[r] < 0.0 ? -amount : amount;
    basis_.push_back(columns_ + r + (b[r] < 0.0 ? rows_ : 0));
  }
  refactor();
}

void Simplex::minimise_residual() {
  cost_ = VectorXd::Zero(a_.cols());
  cost_.tail(2 * rows_).setOnes();
  run(a_.cols());
}

void Simplex::maximise(Index column) {
  expel_slacks();
  cost_ = VectorXd::Zero(a_.cols());
  cost_[column] = -1.0;
  run(columns_);
}

VectorXd Simplex::solution() const {
  const VectorXd basic = inverse_ * b_;
  VectorXd x = VectorXd::Zero(columns_);
  for (std::size_t r = 0; r < basis_.size(); ++r) {
    if (basis_[r] < columns_) x[basis_[r]] = std::max(basic[static_cast<Index>(r)], 0.0);
  }
  return x;
}

VectorXd Simplex::multipliers() const { return inverse_.transpose() * basic_cost(); }

VectorXd Simplex::basic_cost() const {
  VectorXd c(rows_);
  for (std::size_t r = 0; r < basis_.size(); ++r) c[static_cast<Index>(r)] = cost_[basis_[r]];
  return c;
}

bool Simplex::refactor() {
  MatrixXd basis(rows_, rows_);
  for (std::size_t r = 0; r < basis_.size(); ++r) {
    basis.col(static_cast<Index>(r)) = a_.col(basis_[r]);
  }
  const MatrixXd inverse = basis.partialPivLu().inverse();
  since_refactor_ = 0;
  if (!inverse.allFinite() || inverse.cwiseAbs().maxCoeff() > 1e10) {
    basis_ = good_basis_;
    inverse_ = good_inverse_;
    x_ = inverse_ * perturbed_;
    return false;
  }
  good_basis_ = basis_;
  good_inverse_ = inverse_ = inverse;
  x_ = inverse_ * perturbed_;
  return true;
}

bool Simplex::pivot(Index row, Index column, const VectorXd& direction) {
  basis_[static_cast<std::size_t>(row)] = column;
  inverse_.row(row) /= direction[row];
  const Eigen::RowVectorXd pivot_row = inverse_.row(row);
  VectorXd factors = direction;
  factors[row] = 0.0;
  inverse_.noalias() -= factors * pivot_row;
  x_ = inverse_ * perturbed_;
  ++iterations_;
  return ++since_refactor_ < 50 || refactor();
}

void Simplex::expel_slacks() {
  for (Index row = 0; row < rows_; ++row) {
    if (basis_[static_cast<std::size_t>(row)] < columns_) continue;
    const Eigen::RowVectorXd entries = inverse_.row(row) * a_.leftCols(columns_);
    Index column = 0;
    if (entries.cwiseAbs().maxCoeff(&column) < kPivot) continue;  // a redundant equation
    if (!pivot(row, column, inverse_ * a_.col(column))) return;
  }
  refactor();
}

void Simplex::run(Index allowed) {
  const int limit = iterations_ + 40 * static_cast<int>(rows_ + 50);
  while (iterations_ < limit) {
    const VectorXd y = multipliers();
    const VectorXd reduced = cost_.head(allowed) - a_.leftCols(allowed).transpose() * y;
    Index column = 0;
    if (reduced.minCoeff(&column) > -1e-11) {
      if (since_refactor_ == 0 || !refactor()) return;
      continue;
    }
    const VectorXd direction = inverse_ * a_.col(column);
    // Two passes: the smallest ratio with a little slack, then the safest pivot within it.
    double bound = kInfinity;
    for (Index r = 0; r < rows_; ++r) {
      if (direction[r] > kPivot) bound = std::min(bound, (x_[r] + 1e-13) / direction[r]);
    }
    if (bound == kInfinity) return;
    Index leaving = -1;
    for (Index r = 0; r < rows_; ++r) {
      if (direction[r] <= kPivot || x_[r] / direction[r] > bound) continue;
      if (leaving < 0 || direction[r] > direction[leaving]) leaving = r;
    }
    if (!pivot(leaving, column, direction)) return;
  }
}

}  // namespace stiction::reference
