// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/statistics/nonlinear_system.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_multiroots.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "reference/statistics/gsl_errors.h"

namespace stiction::reference {

namespace {

Eigen::VectorXd values_of(const gsl_vector* from) {
  Eigen::VectorXd to(static_cast<Eigen::Index>(from->size));
  for (std::size_t k = 0; k < from->size; ++k) {
    to(static_cast<Eigen::Index>(k)) = gsl_vector_get(from, k);
  }
  return to;
}

void copy(const Eigen::VectorXd& from, gsl_vector* to) {
  for (Eigen::Index k = 0; k < from.size(); ++k) {
    gsl_vector_set(to, static_cast<std::size_t>(k), from(k));
  }
}

int evaluate(const gsl_vector* x, void* system, gsl_vector* f) {
  copy((*static_cast<const System*>(system))(values_of(x)), f);
  return GSL_SUCCESS;
}

struct FreeVector {
  void operator()(gsl_vector* v) const { gsl_vector_free(v); }
};
using Vector = std::unique_ptr<gsl_vector, FreeVector>;

Vector vector_of(const Eigen::VectorXd& values) {
  Vector v(gsl_vector_alloc(static_cast<std::size_t>(values.size())));
  copy(values, v.get());
  return v;
}

}  // namespace

SystemSolution solve_system(const System& f, const Eigen::VectorXd& start, double tolerance,
                            int most_iterations) {
  const auto size = static_cast<std::size_t>(start.size());
  if (size == 0) throw std::invalid_argument("a system of equations needs an unknown");
  quiet_gsl();
  System held = f;
  gsl_multiroot_function function{&evaluate, size, &held};
  const std::unique_ptr<gsl_multiroot_fsolver, void (*)(gsl_multiroot_fsolver*)> solver(
      gsl_multiroot_fsolver_alloc(gsl_multiroot_fsolver_hybrids, size),
      &gsl_multiroot_fsolver_free);
  const Vector x = vector_of(start);
  int status = gsl_multiroot_fsolver_set(solver.get(), &function, x.get());
  SystemSolution solution{start, f(start).cwiseAbs().maxCoeff(), 0, ""};
  while (status == GSL_SUCCESS && solution.iterations < most_iterations) {
    status = gsl_multiroot_test_residual(solver->f, tolerance);
    if (status == GSL_SUCCESS) break;
    status = gsl_multiroot_fsolver_iterate(solver.get());
    ++solution.iterations;
    const double residual = values_of(solver->f).cwiseAbs().maxCoeff();
    if (residual < solution.residual) {
      solution.residual = residual;
      solution.x = values_of(solver->x);
    }
  }
  // The last iteration's own success says nothing of the residual.
  if (status == GSL_SUCCESS) status = gsl_multiroot_test_residual(solver->f, tolerance);
  solution.outcome = gsl_strerror(status == GSL_CONTINUE ? GSL_EMAXITER : status);
  return solution;
}

SystemSolution solve_least_squares(const System& f, const Eigen::VectorXd& start,
                                   int most_iterations) {
  quiet_gsl();
  System held = f;
  const Eigen::VectorXd first = f(start);
  if (first.size() < start.size()) {
    throw std::invalid_argument("least squares needs at least as many residuals as unknowns");
  }
  gsl_multifit_nlinear_fdf function{};
  function.f = &evaluate;
  function.n = static_cast<std::size_t>(first.size());
  function.p = static_cast<std::size_t>(start.size());
  function.params = &held;
  gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  parameters.solver = gsl_multifit_nlinear_solver_svd;
  parameters.fdtype = GSL_MULTIFIT_NLINEAR_CTRDIFF;
  const std::unique_ptr<gsl_multifit_nlinear_workspace, void (*)(gsl_multifit_nlinear_workspace*)>
      workspace(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, function.n,
                                           function.p),
                &gsl_multifit_nlinear_free);
  const Vector x = vector_of(start);
  int info = 0;
  int status = gsl_multifit_nlinear_init(x.get(), &function, workspace.get());
  if (status == GSL_SUCCESS) {
    status = gsl_multifit_nlinear_driver(static_cast<std::size_t>(most_iterations), 1e-15, 1e-15,
                                         0.0, nullptr, nullptr, &info, workspace.get());
  }
  SystemSolution solution;
  solution.x = values_of(workspace->x);
  solution.residual = f(solution.x).cwiseAbs().maxCoeff();
  solution.iterations = static_cast<int>(gsl_multifit_nlinear_niter(workspace.get()));
  solution.outcome = gsl_strerror(status);
  return solution;
}

Eigen::MatrixXd jacobian_of(const System& f, const Eigen::VectorXd& x, double step) {
  Eigen::MatrixXd jacobian;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    Eigen::VectorXd ahead = x, behind = x;
    ahead(j) += step;
    behind(j) -= step;
    const Eigen::VectorXd column = (f(ahead) - f(behind)) / (2.0 * step);
    if (j == 0) jacobian.resize(column.size(), x.size());
    jacobian.col(j) = column;
  }
  return jacobian;
}

double diagonal_dominance(const Eigen::MatrixXd& j) {
  if (j.rows() != j.cols()) throw std::invalid_argument("dominance is of a square matrix");
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < j.rows(); ++i) {
    const double diagonal = std::abs(j(i, i));
    const double others = j.row(i).cwiseAbs().sum() - diagonal;
    if (others > 0.0) least = std::min(least, diagonal / others);
  }
  return least;
}

double spectral_radius(const Eigen::MatrixXd& m) {
  if (m.rows() != m.cols()) throw std::invalid_argument("eigenvalues are of a square matrix");
  quiet_gsl();
  const auto size = static_cast<std::size_t>(m.rows());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = m;
  gsl_matrix_view view = gsl_matrix_view_array(rows.data(), size, size);
  const std::unique_ptr<gsl_eigen_nonsymm_workspace, void (*)(gsl_eigen_nonsymm_workspace*)>
      workspace(gsl_eigen_nonsymm_alloc(size), &gsl_eigen_nonsymm_free);
  const std::unique_ptr<gsl_vector_complex, void (*)(gsl_vector_complex*)> eigenvalues(
      gsl_vector_complex_alloc(size), &gsl_vector_complex_free);
  gsl_eigen_nonsymm_params(0, 1, workspace.get());
  if (gsl_eigen_nonsymm(&view.matrix, eigenvalues.get(), workspace.get()) != GSL_SUCCESS) {
    return std::nan("");
  }
  double radius = 0.0;
  for (std::size_t k = 0; k < size; ++k) {
    const gsl_complex value = gsl_vector_complex_get(eigenvalues.get(), k);
    radius = std::max(radius, std::hypot(GSL_REAL(value), GSL_IMAG(value)));
  }
  return radius;
}

}  // namespace stiction::reference
