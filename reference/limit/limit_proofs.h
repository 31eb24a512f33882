// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "reference/limit/limit_equations.h"

/// Internal to limit analysis: the two certificates, evaluated in rationals without any rounding.
/// They judge what the program in doubles proposes, and take nothing from it on trust. Friction μ
/// and load factor λ are dimensionless; forces and mechanisms (one entry a row: virtual velocities)
/// are in the scaled units of limit_equations.h.
namespace stiction::reference {

/// True if the forces lie in the round cones and leave at most `residual` (scaled, sum over
/// all rows) of the load gravity + λ live gravity unbalanced. This proves that an equilibrium
/// exists.
bool forces_prove(const LimitProblem& problem, double friction, double load_factor,
                  const ContactForces& forces, double residual);

/// True if the mechanism y proves that there is no equilibrium at load factor λ.
bool mechanism_refutes(const LimitProblem& problem, double friction, double load_factor,
                       const Eigen::VectorXd& y, const LimitOptions& options);

/// The largest λ that the mechanism y leaves possible: infinite if it bounds none from above,
/// −infinite if it refutes all in [0, load_max].
double load_bound(const LimitProblem& problem, double friction, const Eigen::VectorXd& y,
                  const LimitOptions& options);

}  // namespace stiction::reference
