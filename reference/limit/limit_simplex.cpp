// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/limit/limit_simplex.h"

#include <glpk.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

namespace stiction::reference {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Index = Eigen::Index;

/// A program as GLPK takes it. Plain data: GLPK's errors jump back over what uses it.
struct Call {
  int rows = 0;
  int columns = 0;
  int allowed = 0;  // the first columns, which may differ from zero
  int entries = 0;
  const int* row_of = nullptr;
  const int* column_of = nullptr;
  const double* entry = nullptr;
  const double* b = nullptr;
  const double* cost = nullptr;
  int* basic = nullptr;  // one entry a column: in the basis before and after
  int pivot_limit = 0;
  int pivots = 0;
  std::jmp_buf error;
  char said[200] = "";  // what GLPK would have printed first
};

void jump_back(void* call) { std::longjmp(static_cast<Call*>(call)->error, 1); }

int keep(void* call, const char* text) {
  char* const said = static_cast<Call*>(call)->said;
  if (*said == '\0') std::strncpy(said, text, sizeof(Call::said) - 1);
  return 1;  // not to be printed
}

void set_up(glp_prob* program, const Call& call) {
  glp_add_rows(program, call.rows);
  glp_add_cols(program, call.columns);
  for (int r = 1; r <= call.rows; ++r) {
    glp_set_row_bnds(program, r, GLP_FX, call.b[r - 1], call.b[r - 1]);
    glp_set_row_stat(program, r, GLP_NS);
  }
  for (int c = 1; c <= call.columns; ++c) {
    glp_set_col_bnds(program, c, c <= call.allowed ? GLP_LO : GLP_FX, 0.0, 0.0);
    glp_set_obj_coef(program, c, call.cost[c - 1]);
    glp_set_col_stat(program, c, call.basic[c - 1] != 0 ? GLP_BS : GLP_NL);
  }
  glp_load_matrix(program, call.entries, call.row_of, call.column_of, call.entry);
}

/// False if GLPK gave up altogether.
bool solve(Call& call) {
  // GLPK keeps its state for each thread. Where this one had none before, none is left.
  const bool mine = glp_init_env() == 0;
  if (setjmp(call.error) != 0) {
    glp_free_env();  // what else may be done after an error
    return false;
  }
  glp_error_hook(jump_back, &call);
  glp_term_hook(keep, &call);
  glp_prob* const program = glp_create_prob();
  set_up(program, call);
  glp_smcp settings;
  glp_init_smcp(&settings);
  settings.msg_lev = GLP_MSG_OFF;
  settings.meth = GLP_PRIMAL;
  // Proofs allow 1e-9 in all, over hundreds of rows and columns.
  settings.tol_bnd = settings.tol_dj = 1e-11;
  settings.it_lim = call.pivot_limit;
  glp_simplex(program, &settings);  // wherever it stopped, its basis may do
  call.pivots = glp_get_it_cnt(program);
  for (int c = 1; c <= call.columns; ++c) {
    call.basic[c - 1] = glp_get_col_stat(program, c) == GLP_BS ? 1 : 0;
  }
  glp_delete_prob(program);
  glp_error_hook(nullptr, nullptr);
  glp_term_hook(nullptr, nullptr);
  if (mine) glp_free_env();
  return true;
}

}  // namespace

Simplex::Simplex(const MatrixXd& a, const VectorXd& b)
    : rows_(a.rows()), columns_(a.cols()), b_(b) {
  if (!a.allFinite() || !b.allFinite()) {
    throw std::invalid_argument("simplex: an entry is not finite");
  }
  a_.resize(rows_, columns_ + 2 * rows_);
  a_ << a, MatrixXd::Identity(rows_, rows_), -MatrixXd::Identity(rows_, rows_);
  row_of_ = column_of_ = {0};
  entry_ = {0.0};
  for (Index c = 0; c < a_.cols(); ++c) {
    for (Index r = 0; r < rows_; ++r) {
      if (a_(r, c) == 0.0) continue;
      row_of_.push_back(static_cast<int>(r) + 1);
      column_of_.push_back(static_cast<int>(c) + 1);
      entry_.push_back(a_(r, c));
    }
  }
  cost_ = VectorXd::Zero(a_.cols());
  std::vector<Index> slacks;
  for (Index r = 0; r < rows_; ++r) slacks.push_back(columns_ + r + (b[r] < 0.0 ? rows_ : 0));
  adopt(std::move(slacks));
}

void Simplex::minimise_residual() {
  cost_.setZero();
  cost_.tail(2 * rows_).setOnes();
  run(true);
}

void Simplex::maximise(Index column) {
  cost_.setZero();
  cost_[column] = -1.0;
  run(false);
}

VectorXd Simplex::solution() const {
  const VectorXd basic = factors_.solve(b_);
  VectorXd x = VectorXd::Zero(columns_);
  for (std::size_t r = 0; r < basis_.size(); ++r) {
    if (basis_[r] < columns_) x[basis_[r]] = std::max(basic[static_cast<Index>(r)], 0.0);
  }
  return x;
}

VectorXd Simplex::multipliers() const {
  VectorXd c(rows_);
  for (std::size_t r = 0; r < basis_.size(); ++r) c[static_cast<Index>(r)] = cost_[basis_[r]];
  return factors_.transpose().solve(c);
}

void Simplex::run(bool with_slacks) {
  std::vector<int> basic(static_cast<std::size_t>(a_.cols()), 0);
  for (const Index column : basis_) basic[static_cast<std::size_t>(column)] = 1;
  Call call;
  call.rows = static_cast<int>(rows_);
  call.columns = static_cast<int>(a_.cols());
  call.allowed = static_cast<int>(with_slacks ? a_.cols() : columns_);
  call.entries = static_cast<int>(entry_.size()) - 1;
  call.row_of = row_of_.data();
  call.column_of = column_of_.data();
  call.entry = entry_.data();
  call.b = b_.data();
  call.cost = cost_.data();
  call.basic = basic.data();
  call.pivot_limit = 40 * static_cast<int>(rows_ + 50);
  if (!solve(call)) {
    std::string said = call.said;
    said.resize(said.find_last_not_of('\n') + 1);
    throw std::runtime_error("simplex: GLPK gave up: " + said);
  }
  iterations_ += call.pivots;
  std::vector<Index> basis;
  for (Index column = 0; column < a_.cols(); ++column) {
    if (basic[static_cast<std::size_t>(column)] != 0) basis.push_back(column);
  }
  adopt(std::move(basis));
}

void Simplex::adopt(std::vector<Index> basis) {
  // Variables of GLPK's own, one a row, may be left in a basis that it gave up.
  if (static_cast<Index>(basis.size()) != rows_) return;
  Eigen::PartialPivLU<MatrixXd> factors(a_(Eigen::all, basis));
  if (factors.matrixLU().diagonal().cwiseAbs().minCoeff() == 0.0) return;
  basis_ = std::move(basis);
  factors_ = std::move(factors);
}

}  // namespace stiction::reference
