// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

namespace stiction::reference {

/// A system of equations f(x) = 0, or of residuals f(x); as many values for every x.
using System = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

struct SystemSolution {
  Eigen::VectorXd x;
  double residual = 0.0;  ///< max |fᵢ(x)|, unit of f
  int iterations = 0;
  std::string outcome;  ///< "success", or why GSL stopped
};

/// Root of as many equations as unknowns by GSL's scaled hybrid method (Powell, finite-difference
/// Jacobian, `gsl_multiroot_fsolver_hybrids`), until Σ|fᵢ| ≤ `tolerance` or it stalls. The best
/// point seen is returned with its residual either way.
SystemSolution solve_system(const System& f, const Eigen::VectorXd& start, double tolerance,
                            int most_iterations = 200);

/// Minimises Σ fᵢ² by GSL's trust-region Levenberg–Marquardt (`gsl_multifit_nlinear`, singular
/// value solver, so that f may have fewer independent equations than unknowns).
/// Precondition: at least as many residuals as unknowns.
SystemSolution solve_least_squares(const System& f, const Eigen::VectorXd& start,
                                   int most_iterations = 100);

/// ∂fᵢ/∂xⱼ at x by central differences of half-width `step`: equations × unknowns.
Eigen::MatrixXd jacobian_of(const System& f, const Eigen::VectorXd& x, double step);

/// Smallest over the rows of |Jᵢᵢ|/Σⱼ≠ᵢ|Jᵢⱼ|: above 1 the square matrix is strictly diagonally
/// dominant. Infinite for a diagonal one.
double diagonal_dominance(const Eigen::MatrixXd& j);

/// Largest modulus of the eigenvalues of a square matrix (GSL, non-symmetric).
double spectral_radius(const Eigen::MatrixXd& m);

}  // namespace stiction::reference
